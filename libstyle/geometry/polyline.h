// SPDX-License-Identifier: Apache-2.0
// The curve that the algorithms work on: a list of points joined by straight lines.
#pragma once

#include <cstddef>
#include <vector>

#include "libstyle/geometry/point.h"

namespace libstyle {

// A closed polyline also joins its last point to its first, and does not repeat the first.
struct Polyline {
  std::vector<Point> points;
  bool closed = false;

  friend bool operator==(const Polyline&, const Polyline&) = default;
};

// Segment i goes from point i to point i + 1; the last one of a closed polyline goes back to point
// 0. A single point has no segment.
inline std::size_t segment_count(const Polyline& polyline) {
  const std::size_t points = polyline.points.size();
  if (points < 2) return 0;
  return polyline.closed ? points : points - 1;
}

inline std::size_t segment_end_index(const Polyline& polyline, std::size_t segment) {
  return segment + 1 < polyline.points.size() ? segment + 1 : 0;
}

inline Point segment_start(const Polyline& polyline, std::size_t segment) {
  return polyline.points[segment];
}

inline Point segment_end(const Polyline& polyline, std::size_t segment) {
  return polyline.points[segment_end_index(polyline, segment)];
}

// A place on a polyline: `fraction` of the way, 0 .. 1, along a segment.
struct PolylinePlace {
  std::size_t segment = 0;
  double fraction = 0;

  friend bool operator==(const PolylinePlace&, const PolylinePlace&) = default;
};

// Exactly a vertex where the fraction is 0 or 1. The only place of a single point is {0, 0}.
inline Point point_at(const Polyline& polyline, PolylinePlace place) {
  const Point start = segment_start(polyline, place.segment);
  if (place.fraction == 0) return start;
  const Point end = segment_end(polyline, place.segment);
  return place.fraction == 1 ? end : lerp(start, end, place.fraction);
}

}  // namespace libstyle
