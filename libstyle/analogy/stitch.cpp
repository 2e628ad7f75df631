// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/stitch.h"

#include <cassert>
#include <cstddef>

namespace libstyle {
namespace {

// A symmetric matrix with `diagonal`, the entries `beside` next to it, and, if cyclic, `corner` in
// the two far corners.
struct Tridiagonal {
  std::vector<double> diagonal;
  std::vector<double> beside;  // one less than diagonal
  double corner = 0;
};

// Thomas algorithm, for real numbers and points; stable for the diagonally dominant matrices here.
template <typename Value>
std::vector<Value> solve_open(const Tridiagonal& matrix, std::vector<Value> right) {
  const std::size_t n = right.size();
  std::vector<double> upper(n);
  double pivot = matrix.diagonal[0];
  right[0] = right[0] / pivot;
  for (std::size_t i = 1; i < n; ++i) {
    upper[i] = matrix.beside[i - 1] / pivot;
    pivot = matrix.diagonal[i] - matrix.beside[i - 1] * upper[i];
    right[i] = (right[i] - matrix.beside[i - 1] * right[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 0;) right[i] = right[i] - upper[i + 1] * right[i + 1];
  return right;
}

// Sherman-Morrison: the cyclic matrix is a tridiagonal one plus u v^T with
// u = (g, 0, ..., corner) and v = (1, 0, ..., corner / g).
std::vector<Point> solve_cyclic(Tridiagonal matrix, const std::vector<Point>& right) {
  const std::size_t n = right.size();
  const double g = -matrix.diagonal.front();
  const double ratio = matrix.corner / g;
  std::vector<double> u(n, 0.0);
  u.front() = g;
  u.back() = matrix.corner;
  matrix.diagonal.front() -= g;
  matrix.diagonal.back() -= matrix.corner * ratio;
  std::vector<Point> points = solve_open(matrix, right);
  const std::vector<double> z = solve_open(matrix, u);
  const Point along_v = points.front() + ratio * points.back();
  const Point factor = along_v / (1 + z.front() + ratio * z.back());
  for (std::size_t i = 0; i < n; ++i) points[i] -= z[i] * factor;
  return points;
}

}  // namespace

std::vector<Point> stitch(std::span<const Point> anchors, std::span<const Vector> steps,
                          std::span<const double> lengths, double reach, bool closed) {
  const std::size_t n = anchors.size();
  const std::size_t intervals = closed ? n : n - 1;
  assert(n > 0 && steps.size() == intervals && lengths.size() == intervals && (!closed || n > 2));
  Tridiagonal matrix{std::vector<double>(n, 0.0), std::vector<double>(n - 1, 0.0)};
  std::vector<Point> right(n);
  for (std::size_t i = 0; i < intervals; ++i) {
    const std::size_t next = i + 1 < n ? i + 1 : 0;
    const double stiffness = 1 / lengths[i];
    const double screening = lengths[i] / (2 * reach * reach);
    matrix.diagonal[i] += stiffness + screening;
    matrix.diagonal[next] += stiffness + screening;
    (next > 0 ? matrix.beside[i] : matrix.corner) = -stiffness;
    right[i] += screening * anchors[i] - stiffness * steps[i];
    right[next] += screening * anchors[next] + stiffness * steps[i];
  }
  if (n == 1) return {anchors.begin(), anchors.end()};
  return closed ? solve_cyclic(std::move(matrix), right) : solve_open(matrix, std::move(right));
}

}  // namespace libstyle
