// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/sweep.h"

#include <algorithm>
#include <cassert>

#include "libstyle/geometry/gaussian.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {
namespace {

// Vertices a blur of this standard deviation needs to show its shape; by trial, finer ones change
// the directions by less than a degree.
constexpr double kVerticesPerBlur = 4;

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
