// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/literal/neighborhood.h"

#include <algorithm>
#include <cmath>

namespace libstyle::literal {
namespace {

constexpr double kEndTolerance = 1e-9;  // spacings; a sample on the end point exists

std::complex<double> complex(Vector v) { return {v.x, v.y}; }

// The tangent of sample k, which needs sample k - 1 in both neighborhoods.
bool have_tangent(const Neighborhood& a, const Neighborhood& b, std::size_t k) {
  return k > 0 && a[k - 1] && a[k] && b[k - 1] && b[k];
}

Vector tangent(const Neighborhood& a, std::size_t k) { return normalized(*a[k] - *a[k - 1]); }

}  // namespace

Neighborhood sample_neighborhood(const ArcLength& curve, double center, double spacing,
                                 std::size_t count) {
  Neighborhood samples(count);
  const Polyline& polyline = curve.polyline();
  const auto cumulative = curve.cumulative();
  const double total = curve.total(), tolerance = kEndTolerance * spacing;
  if (polyline.points.size() < 2) {
    for (std::size_t k = 0; k < count && !polyline.points.empty(); ++k) {
      const double offset =
          center + (static_cast<double>(k) - static_cast<double>(count / 2)) * spacing;
      if (std::abs(offset) <= tolerance) samples[k] = polyline.points[0];
    }
    return samples;
  }
  std::size_t segment = 0;
  bool found = false;
  for (std::size_t k = 0; k < count; ++k) {
    double length = center + (static_cast<double>(k) - static_cast<double>(count / 2)) * spacing;
    if (polyline.closed) length -= total * std::floor(length / total);
    if (length < -tolerance || length > total + tolerance) continue;
    if (!found || length < cumulative[segment]) {
      const auto after = std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, length);
      segment = static_cast<std::size_t>(after - cumulative.begin()) - 1;
      found = true;
    }
    while (segment + 1 < segment_count(polyline) && cumulative[segment + 1] < length) ++segment;
    const double size = cumulative[segment + 1] - cumulative[segment];
    const double fraction = size > 0 ? (length - cumulative[segment]) / size : 0;
    samples[k] = lerp(segment_start(polyline, segment), segment_end(polyline, segment),
                      std::fmin(std::fmax(fraction, 0), 1));
  }
  return samples;
}

std::vector<double> binomial_weights(int order, int count) {
  std::vector<double> weights(static_cast<std::size_t>(count));
  const int n = order - 1, middle = n / 2;
  double weight = 1;
  for (int k = 0; k <= count / 2; ++k) {
    weights[static_cast<std::size_t>(count / 2 + k)] = weight;
    weights[static_cast<std::size_t>(count / 2 - k)] = weight;
    weight *= static_cast<double>(n - middle - k) / static_cast<double>(middle + k + 1);
  }
  return weights;
}

Comparison compare(const Neighborhood& a, const Neighborhood& b, const std::vector<double>& weights,
                   double tangent_weight) {
  Comparison result;
  double weight_of_b = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (b[k]) weight_of_b += weights[k];
    if (!a[k] || !b[k]) continue;
    result.weight += weights[k];
    result.mean_a += weights[k] * *a[k];
    result.mean_b += weights[k] * *b[k];
  }
  if (result.weight == 0) return result;
  result.overlap = result.weight / weight_of_b;
  result.scale = weight_of_b / result.weight;
  result.mean_a = result.mean_a / result.weight;
  result.mean_b = result.mean_b / result.weight;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (!a[k] || !b[k]) continue;
    result.twist +=
        weights[k] * std::conj(complex(*a[k] - result.mean_a)) * complex(*b[k] - result.mean_b);
    if (!have_tangent(a, b, k)) continue;
    result.twist +=
        weights[k] * tangent_weight * std::conj(complex(tangent(a, k))) * complex(tangent(b, k));
  }
  return result;
}

double shape_distance(const Neighborhood& a, const Neighborhood& b, const Comparison& comparison,
                      std::complex<double> rotation, const std::vector<double>& weights,
                      double tangent_weight) {
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (!a[k] || !b[k]) continue;
    const Vector moved = turn(rotation, *a[k] - comparison.mean_a) + comparison.mean_b;
    sum += weights[k] * squared_norm(moved - *b[k]);
    if (!have_tangent(a, b, k)) continue;
    sum +=
        weights[k] * tangent_weight * squared_norm(turn(rotation, tangent(a, k)) - tangent(b, k));
  }
  return sum;
}

Vector turn(std::complex<double> rotation, Vector v) {
  const std::complex<double> turned = rotation * complex(v);
  return {turned.real(), turned.imag()};
}

}  // namespace libstyle::literal
