// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/flatten.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "libstyle/base/error.h"

namespace libstyle {
namespace {

std::size_t checked_steps(const PathSegment& segment, double tolerance) {
  if (segment.straight) return 1;
  const double steps = flattening_steps(segment.curve, tolerance);
  if (!(steps < static_cast<double>(kMaxFlattenedPoints))) {
    throw Error("a curve would need more than " + std::to_string(kMaxFlattenedPoints) +
                " points to be flattened; its coordinates are too large for the tolerance");
  }
  return static_cast<std::size_t>(steps);
}

void append_segment(FlattenedSubpath& flat, const PathSegment& segment, double tolerance) {
  const std::size_t steps = checked_steps(segment, tolerance);
  for (std::size_t i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(steps);
    flat.polyline.points.push_back(point_at(segment.curve, t));
    flat.places.push_back({segment.start_vertex, segment.end_vertex, t});
  }
}

FlattenedSubpath flatten_subpath(const Subpath& subpath, Point first, double tolerance) {
  FlattenedSubpath flat;
  flat.polyline = {{first}, subpath.closed};
  if (subpath.segments.empty()) {
    flat.places = {{subpath.first_vertex, subpath.first_vertex, 0}};
    return flat;
  }
  const PathSegment& head = subpath.segments.front();
  flat.places = {{head.start_vertex, head.end_vertex, 0}};
  for (const PathSegment& segment : subpath.segments) append_segment(flat, segment, tolerance);
  const bool repeats_first =
      flat.polyline.points.size() > 1 && flat.polyline.points.back() == first;
  if (subpath.closed && repeats_first) {
    flat.polyline.points.pop_back();
    flat.places.pop_back();
  }
  return flat;
}

}  // namespace

double flattening_steps(const CubicBezier& curve, double tolerance) {
  assert(tolerance > 0);
  const double second_difference =
      std::sqrt(std::max(squared_norm(curve.p0 - 2 * curve.p1 + curve.p2),
                         squared_norm(curve.p1 - 2 * curve.p2 + curve.p3)));
  return std::max(std::ceil(std::sqrt(0.75 * second_difference / tolerance)), 1.0);
}

std::vector<FlattenedSubpath> flatten(const Path& path, double tolerance) {
  const std::vector<Point> vertices = path.vertices();
  std::vector<FlattenedSubpath> result;
  for (const Subpath& subpath : subpaths(path)) {
    result.push_back(flatten_subpath(subpath, vertices[subpath.first_vertex], tolerance));
  }
  return result;
}

std::vector<double> values_along(std::span<const PathPlace> places,
                                 std::span<const double> vertex_values) {
  std::vector<double> values;
  values.reserve(places.size());
  for (const PathPlace& place : places) {
    const double start = vertex_values[place.start_vertex], end = vertex_values[place.end_vertex];
    values.push_back(place.t == 1 ? end : start + place.t * (end - start));
  }
  return values;
}

}  // namespace libstyle
