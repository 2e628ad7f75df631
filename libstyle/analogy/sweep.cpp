// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "libstyle/geometry/gaussian.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {
namespace {

// Vertices a blur of this standard deviation needs to show its shape; by trial, finer ones change
// the directions by less than a degree.
constexpr double kVerticesPerBlur = 4;

// Samples to each side of a place that is blurred, and how many standard deviations they reach.
constexpr int kBlurTaps = 16;
constexpr double kBlurReach = 3.5;

// Adds vertices, keeping all the given ones, until none is farther than `spacing` from the next.
Polyline with_more_vertices(const Polyline& curve, double spacing) {
  Polyline result{{}, curve.closed};
  for (std::size_t i = 0; i < segment_count(curve); ++i) {
    const Point start = segment_start(curve, i), end = segment_end(curve, i);
    const double parts = std::max(1.0, std::ceil(distance(start, end) / spacing));
    for (double part = 0; part < parts; ++part) {
      result.points.push_back(lerp(start, end, part / parts));
    }
  }
  if (!curve.closed) result.points.push_back(curve.points.back());
  return result;
}

std::vector<Vector> vertex_directions(const Polyline& curve) {
  const std::size_t n = curve.points.size();
  std::vector<Vector> directions(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = i > 0 ? i - 1 : (curve.closed ? n - 1 : 0);
    const std::size_t after = i + 1 < n ? i + 1 : (curve.closed ? 0 : n - 1);
    directions[i] = normalized(curve.points[after] - curve.points[before]);
    // A curve that turns back on itself has no direction there; it keeps the last one.
    if (directions[i] == Vector{} && i > 0) directions[i] = directions[i - 1];
  }
  return directions;
}

}  // namespace

Sweep::Sweep(const Polyline& curve, double smoothing, double frame_blur, Invariance invariance)
    : along_(with_more_vertices(curve,
                                std::max(arc_length(curve) / 4096, frame_blur / kVerticesPerBlur))),
      places_(smoothing > 0 ? gaussian_blur(along_.polyline(), smoothing) : along_.polyline()),
      directions_(vertex_directions(gaussian_blur(along_.polyline(), frame_blur))),
      invariance_(invariance) {
  assert(length() > 0);
}

Point Sweep::point_at(double length) const {
  return libstyle::point_at(places_, along_.place_at(length));
}

// Beyond an end the curve goes on as its point reflection there, so that the end stays.
Point Sweep::point_at(double length, double blur) const {
  if (!(blur > 0)) return point_at(length);
  const auto extended = [&](double at) {
    const double inside = closed() ? at : std::clamp(at, 0.0, this->length());
    return inside == at ? point_at(at) : 2 * point_at(inside) - point_at(2 * inside - at);
  };
  Point sum;
  double weights = 0;
  for (int tap = -kBlurTaps; tap <= kBlurTaps; ++tap) {
    const double u = kBlurReach * tap / kBlurTaps;
    const double weight = std::exp(-0.5 * u * u);
    sum += weight * extended(length + u * blur);
    weights += weight;
  }
  return sum / weights;
}

Vector Sweep::frame_at(double length) const {
  return invariance_ == Invariance::kTranslate ? Vector{1, 0} : direction_at(length);
}

Vector Sweep::direction_at(double length) const {
  const PolylinePlace place = along_.place_at(length);
  const Vector start = directions_[place.segment];
  const Vector end = directions_[segment_end_index(places_, place.segment)];
  const Vector between = normalized(lerp(start, end, place.fraction));
  return between == Vector{} ? start : between;
}

}  // namespace libstyle
