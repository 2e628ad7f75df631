// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/cubic_segment_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libstyle/geometry/polygon.h"

namespace libstyle {
namespace {

constexpr int kRounds = 4;

// Beyond this many tolerances at first, rounds do not help; below this gain they are not worth it.
constexpr double kHopeless = 5;
constexpr double kLeastGain = 0.95;

// Handles in shares of the arc. A half circle needs 0.42.
constexpr double kShortestHandle = 1e-3;
constexpr double kLongestHandle = 0.75;

double control_polygon_turn(const CubicBezier& curve) {
  const Vector a = curve.p1 - curve.p0, b = curve.p2 - curve.p1, c = curve.p3 - curve.p2;
  if (b == Vector{}) return std::abs(turning_angle(a, c));
  return std::abs(turning_angle(a, b)) + std::abs(turning_angle(b, c));
}

// The sums of the least-squares problem for the two handle lengths.
struct HandleEquations {
  double a11 = 0, a12 = 0, a22 = 0, b1 = 0, b2 = 0;

  // Lengths within [low, high]: where the minimum lies outside, on the border.
  std::pair<double, double> solve(double low, double high) const {
    const double determinant = a11 * a22 - a12 * a12;
    const auto second = [&](double first) {
      return std::clamp(a22 > 0 ? (b2 - a12 * first) / a22 : low, low, high);
    };
    const auto first = [&](double other) {
      return std::clamp(a11 > 0 ? (b1 - a12 * other) / a11 : low, low, high);
    };
    if (determinant > 1e-12 * a11 * a22) {
      const double x = (b1 * a22 - b2 * a12) / determinant;
      const double y = (a11 * b2 - a12 * b1) / determinant;
      const bool x_fits = x >= low && x <= high, y_fits = y >= low && y <= high;
      if (x_fits && y_fits) return {x, y};
      if (y_fits) return {std::clamp(x, low, high), second(std::clamp(x, low, high))};
      if (x_fits) return {first(std::clamp(y, low, high)), std::clamp(y, low, high)};
    }
    const double x = first((low + high) / 2);
    return {x, second(x)};
  }
};

}  // namespace

void SegmentFitter::set_parameters_by_length(std::span<const ArcSample> samples) {
  const double origin = samples.front().length, arc = samples.back().length - origin;
  parameters_.clear();
  for (const ArcSample& sample : samples) parameters_.push_back((sample.length - origin) / arc);
}

CubicBezier SegmentFitter::with_best_handles(std::span<const ArcSample> samples,
                                             const LocalFit& start, const LocalFit& end) const {
  HandleEquations equations;
  const double tangents = dot(start.tangent, end.tangent);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = parameters_[i], s = 1 - t;
    const double basis1 = 3 * s * s * t, basis2 = 3 * s * t * t;
    const double start_share = s * s * s + basis1;
    const Vector rest = samples[i].position - lerp(end.position, start.position, start_share);
    const double weight = samples[i].weight;
    equations.a11 += weight * basis1 * basis1;
    equations.a12 -= weight * basis1 * basis2 * tangents;
    equations.a22 += weight * basis2 * basis2;
    equations.b1 += weight * basis1 * dot(rest, start.tangent);
    equations.b2 -= weight * basis2 * dot(rest, end.tangent);
  }
  const double arc = samples.back().length - samples.front().length;
  const auto [first, second] = equations.solve(kShortestHandle * arc, kLongestHandle * arc);
  return {start.position, start.position + first * start.tangent,
          end.position - second * end.tangent, end.position};
}

// One Newton step each towards the nearest place on the curve.
SegmentFitter::Distances SegmentFitter::improve_parameters(std::span<const ArcSample> samples,
                                                           const CubicBezier& curve) {
  double all = 0, vertices = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    double& t = parameters_[i];
    const Vector offset = point_at(curve, t) - samples[i].position;
    const Vector velocity = derivative_at(curve, t);
    const double slope = squared_norm(velocity) + dot(offset, second_derivative_at(curve, t));
    const double moved = slope > 0 ? std::clamp(t - dot(offset, velocity) / slope, 0.0, 1.0) : t;
    const double before = squared_norm(offset);
    const double after = squared_norm(point_at(curve, moved) - samples[i].position);
    if (after < before) t = moved;
    all = std::max(all, std::min(before, after));
    if (samples[i].vertex != kNoVertex) vertices = std::max(vertices, std::min(before, after));
  }
  return {std::sqrt(all), std::sqrt(vertices)};
}

std::optional<SegmentFit> SegmentFitter::fit(std::span<const ArcSample> samples,
                                             const LocalFit& start, const LocalFit& end,
                                             double tolerance) {
  set_parameters_by_length(samples);
  double previous = kHopeless * tolerance;
  for (int round = 0; round < kRounds; ++round) {
    const CubicBezier curve = with_best_handles(samples, start, end);
    const auto [error, vertex_error] = improve_parameters(samples, curve);
    if (error <= tolerance) {
      if (control_polygon_turn(curve) > std::numbers::pi) return std::nullopt;
      return SegmentFit{curve, vertex_error};
    }
    if (error > kLeastGain * previous) return std::nullopt;
    previous = error;
  }
  return std::nullopt;
}

SegmentFit SegmentFitter::fit_neighbours(std::span<const ArcSample> samples, const LocalFit& start,
                                         const LocalFit& end, double tolerance) {
  const Vector chord = end.position - start.position;
  const double length = norm(chord);
  const Vector along = normalized(chord);
  // A handle h at an angle to the chord bulges by less than h sin(angle) / 2.
  const auto handle = [&](Vector tangent) -> Vector {
    const double forward = dot(along, tangent), sideways = std::abs(cross(along, tangent));
    if (forward <= 0) return chord / 3;
    return std::min(length / 3 * forward, 2 * tolerance / std::max(sideways, 1e-9)) * tangent;
  };
  const CubicBezier curve{start.position, start.position + handle(start.tangent),
                          end.position - handle(end.tangent), end.position};
  set_parameters_by_length(samples);
  for (int round = 1; round < kRounds; ++round) improve_parameters(samples, curve);
  return {curve, improve_parameters(samples, curve).of_vertices};
}

}  // namespace libstyle
