// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/principal_components.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>

#include "libstyle/base/random.h"

namespace libstyle::image {
namespace {

using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::MatrixXf covariance(const RowMajor& centred) {
  return (centred.transpose() * centred) / static_cast<float>(centred.rows());
}

Eigen::MatrixXf orthonormal(const Eigen::MatrixXf& columns) {
  const Eigen::HouseholderQR<Eigen::MatrixXf> factors(columns);
  return factors.householderQ() * Eigen::MatrixXf::Identity(columns.rows(), columns.cols());
}

// A start that has something of every direction.
Eigen::MatrixXf start(Eigen::Index rows, Eigen::Index columns) {
  const RandomStream random(0, 0);
  Eigen::MatrixXf result(rows, columns);
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    result.data()[i] = static_cast<float>(random.uniform(static_cast<std::uint64_t>(i)) - 0.5);
  }
  return result;
}

}  // namespace

PrincipalComponents principal_components(const std::vector<float>& vectors, std::size_t length,
                                         std::size_t most, double share) {
  constexpr int kIterations = 8;
  const auto size = static_cast<Eigen::Index>(length);
  const Eigen::Index wanted = std::min(size, static_cast<Eigen::Index>(most));
  RowMajor centred = Eigen::Map<const RowMajor>(
      vectors.data(), static_cast<Eigen::Index>(vectors.size() / length), size);
  const Eigen::RowVectorXf mean = centred.colwise().mean();
  centred.rowwise() -= mean;
  const Eigen::MatrixXf variance = covariance(centred);
  Eigen::MatrixXf basis = orthonormal(start(size, wanted));
  for (int i = 0; i < kIterations; ++i) basis = orthonormal(variance * basis);

  // Within the subspace the directions are sorted exactly.
  const Eigen::MatrixXf within = basis.transpose() * variance * basis;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXf> solver(within);
  const Eigen::MatrixXf sorted = (basis * solver.eigenvectors()).rowwise().reverse();
  const Eigen::VectorXf values = solver.eigenvalues().reverse();

  const double total = variance.trace();
  PrincipalComponents result{length, 0, {mean.begin(), mean.end()}, {}, 0};
  double kept = 0;
  do {
    kept += std::max(0.F, values[static_cast<Eigen::Index>(result.count++)]);
  } while (kept < share * total && result.count < static_cast<std::size_t>(wanted));
  result.kept_share = total > 0 ? std::min(1.0, kept / total) : 1;
  for (std::size_t i = 0; i < length; ++i) {
    for (std::size_t j = 0; j < result.count; ++j) {
      result.basis.push_back(sorted(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    }
  }
  return result;
}

}  // namespace libstyle::image
