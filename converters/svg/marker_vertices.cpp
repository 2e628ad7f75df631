// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/marker_vertices.h"

#include "libstyle/geometry/path_segments.h"

namespace libstyle::svg {
namespace {

struct Directions {
  Vector leaving;   // at its start
  Vector arriving;  // at its end
};

// Those of each segment of a subpath.
std::vector<Directions> directions_of(const std::vector<PathSegment>& segments) {
  std::vector<Directions> directions;
  for (const PathSegment& segment : segments) {
    directions.push_back({tangent_at(segment.curve, 0), tangent_at(segment.curve, 1)});
  }
  Vector last;
  for (Directions& own : directions) {
    if (own.arriving == Vector{}) own.arriving = last;
    last = own.arriving;
  }
  Vector next = last == Vector{} ? Vector{1, 0} : last;
  for (std::size_t i = directions.size(); i-- > 0;) {
    if (directions[i].arriving == Vector{}) directions[i].arriving = next;
    if (directions[i].leaving == Vector{}) directions[i].leaving = next;
    next = directions[i].leaving;
  }
  return directions;
}

// Halfway between two directions; across, where they are opposite.
Vector between(Vector arriving, Vector leaving) {
  const Vector sum = arriving + leaving;
  return norm(sum) > 1e-9 ? normalized(sum) : Vector{-arriving.y, arriving.x};
}

void append_subpath(const Subpath& subpath, std::vector<MarkerVertex>& vertices) {
  if (subpath.segments.empty()) return;
  const std::vector<Directions> directions = directions_of(subpath.segments);
  const Vector first = directions.front().leaving, last = directions.back().arriving;
  vertices.push_back({MarkerPlace::kMid, subpath.segments.front().curve.p0, first});
  for (std::size_t i = 0; i + 1 < directions.size(); ++i) {
    vertices.push_back({MarkerPlace::kMid, subpath.segments[i].curve.p3,
                        between(directions[i].arriving, directions[i + 1].leaving)});
  }
  vertices.push_back({MarkerPlace::kMid, subpath.segments.back().curve.p3,
                      subpath.closed ? between(last, first) : last});
}

}  // namespace

std::vector<MarkerVertex> marker_vertices(const Path& path) {
  std::vector<MarkerVertex> vertices;
  for (const Subpath& subpath : subpaths(path)) append_subpath(subpath, vertices);
  if (!vertices.empty()) {
    vertices.front().place = MarkerPlace::kStart;
    vertices.back().place = MarkerPlace::kEnd;
  }
  return vertices;
}

}  // namespace libstyle::svg
