// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/warp.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace libstyle {
namespace {

constexpr double kSamePlace = 1e-3;  // of the width; nearer targets make the matrix singular

// Cholesky factorisation in place and two substitutions; the matrix is positive definite and small.
void solve(std::vector<std::vector<double>>& matrix, std::span<WarpTarget> right) {
  const std::size_t n = right.size();
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < j; ++k) matrix[j][j] -= matrix[j][k] * matrix[j][k];
    matrix[j][j] = std::sqrt(matrix[j][j]);
    for (std::size_t i = j + 1; i < n; ++i) {
      for (std::size_t k = 0; k < j; ++k) matrix[i][j] -= matrix[i][k] * matrix[j][k];
      matrix[i][j] /= matrix[j][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i].offset -= matrix[i][k] * right[k].offset;
    right[i].offset = right[i].offset / matrix[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) right[i].offset -= matrix[k][i] * right[k].offset;
    right[i].offset = right[i].offset / matrix[i][i];
  }
}

}  // namespace

Warp::Warp(std::span<const WarpTarget> targets, double width) : width_(width) {
  for (const WarpTarget& target : targets) {
    const bool taken = std::ranges::any_of(bumps_, [&](const WarpTarget& other) {
      return std::abs(other.position - target.position) < kSamePlace * width;
    });
    if (!taken) bumps_.push_back(target);
  }
  std::vector<std::vector<double>> matrix(bumps_.size(), std::vector<double>(bumps_.size()));
  for (std::size_t i = 0; i < bumps_.size(); ++i) {
    for (std::size_t k = 0; k < bumps_.size(); ++k) {
      matrix[i][k] = kernel(bumps_[i].position - bumps_[k].position);
    }
  }
  solve(matrix, bumps_);
}

Vector Warp::at(double position) const {
  Vector sum;
  for (const WarpTarget& bump : bumps_) sum += kernel(position - bump.position) * bump.offset;
  return sum;
}

double Warp::kernel(double distance) const {
  const double ratio = distance / width_;
  return std::exp(-0.5 * ratio * ratio);
}

}  // namespace libstyle
