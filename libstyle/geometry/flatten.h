// SPDX-License-Identifier: Apache-2.0
// A path as polylines that stay within a stated distance of it.
//
//   for (const FlattenedSubpath& flat : flatten(path, 0.1)) draw(flat.polyline);
//
// Guarantee: at every parameter t of a cubic the polyline's point at the same t lies within
// `tolerance` of the curve's. Hence neither is farther than that from the other (Hausdorff
// distance), and values that are interpolated along t belong to the right place.
//
// Proof: linear interpolation of B over a parameter step h errs by at most h^2 / 8 max |B''|, and
// B'' = 6 (1 - t)(p0 - 2 p1 + p2) + 6 t (p1 - 2 p2 + p3) is largest at an end. So
//   n = ceil(sqrt(6 max(|p0 - 2 p1 + p2|, |p1 - 2 p2 + p3|) / (8 tolerance)))
// even steps suffice (Wang's formula; see Goldman, "Pyramid algorithms", 2003, section 5.6.3).
//
// Vertices of the path are points of the polyline, bit for bit. Cost: O(points made).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/geometry/path.h"
#include "libstyle/geometry/path_segments.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

// Where on the path a point came from: parameter t, 0 .. 1, between two of Path::vertices().
struct PathPlace {
  std::size_t start_vertex = 0;
  std::size_t end_vertex = 0;
  double t = 0;

  friend bool operator==(const PathPlace&, const PathPlace&) = default;
};

struct FlattenedSubpath {
  Polyline polyline;
  std::vector<PathPlace> places;  // one for each point
};

// One polyline for each subpath, in order; a subpath of M alone is a single point. A closed subpath
// does not repeat its first point at the end, even when the path does before its Z.
// `tolerance` > 0. Throws Error when a segment would need more than kMaxFlattenedPoints points or
// is not finite.
std::vector<FlattenedSubpath> flatten(const Path& path, double tolerance);

inline constexpr std::size_t kMaxFlattenedPoints = std::size_t{1} << 20;

// How many even steps of t keep the bound above.
double flattening_steps(const CubicBezier& curve, double tolerance);

// Values at the path's vertices, interpolated linearly in t at the flattened points.
std::vector<double> values_along(std::span<const PathPlace> places,
                                 std::span<const double> vertex_values);

}  // namespace libstyle
