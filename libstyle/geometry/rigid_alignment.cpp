// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/rigid_alignment.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace libstyle {
namespace {

double weight_at(std::span<const double> weights, std::size_t i) {
  return weights.empty() ? 1 : weights[i];
}

// Summed relative to the first point: far from the origin nothing is lost, and the mean of points
// that coincide is that point exactly.
Point weighted_mean(std::span<const Point> points, std::span<const double> weights) {
  Point sum;
  double total = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double weight = weight_at(weights, i);
    sum += weight * (points[i] - points[0]);
    total += weight;
  }
  assert(total > 0);
  return points[0] + sum / total;
}

// Point by point: the closed form of the head comment cancels when the fit is good.
double residual(const RigidTransform& target_from_source, std::span<const Point> source,
                std::span<const Point> target, std::span<const double> weights) {
  double sum = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    sum += weight_at(weights, i) * squared_norm(target_from_source(source[i]) - target[i]);
  }
  return sum;
}

// Unit vector along v; +x when v is zero. Scaled first, so that tiny and huge vectors keep their
// direction.
Vector direction_or_x(Vector v) {
  const double scale = std::max(std::abs(v.x), std::abs(v.y));
  return scale > 0 ? normalized(v / scale) : Vector{1, 0};
}

// conj(a) * b of two points as complex numbers.
Vector conjugate_product(Vector a, Vector b) { return {dot(a, b), cross(a, b)}; }

}  // namespace

RigidTransform rotation_between(Vector from, Vector to, Point center) {
  const Vector turn = direction_or_x(conjugate_product(direction_or_x(from), direction_or_x(to)));
  RigidTransform result{turn.x, turn.y, {}};
  result.translation = center - result.linear(center);
  return result;
}

RigidAlignment align_rigidly(std::span<const Point> source, std::span<const Point> target,
                             std::span<const double> weights) {
  assert(!source.empty() && source.size() == target.size());
  assert(weights.empty() || weights.size() == source.size());
  const Point source_mean = weighted_mean(source, weights);
  const Point target_mean = weighted_mean(target, weights);
  Vector sum;
  for (std::size_t i = 0; i < source.size(); ++i) {
    sum +=
        weight_at(weights, i) * conjugate_product(source[i] - source_mean, target[i] - target_mean);
  }
  const Vector turn = direction_or_x(sum);
  RigidTransform result{turn.x, turn.y, {}};
  result.translation = target_mean - result.linear(source_mean);
  return {result, residual(result, source, target, weights)};
}

RigidAlignment align_by_translation(std::span<const Point> source, std::span<const Point> target,
                                    std::span<const double> weights) {
  assert(!source.empty() && source.size() == target.size());
  assert(weights.empty() || weights.size() == source.size());
  RigidTransform result;
  result.translation = weighted_mean(target, weights) - weighted_mean(source, weights);
  return {result, residual(result, source, target, weights)};
}

}  // namespace libstyle
