// SPDX-License-Identifier: Apache-2.0
// A path seen as segments between vertices, one subpath at a time.
#pragma once

#include <cstddef>
#include <vector>

#include "libstyle/geometry/bezier.h"
#include "libstyle/geometry/box.h"
#include "libstyle/geometry/path.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

// The curve from one vertex of a path to another: the vertices as Path::vertices counts them.
struct PathSegment {
  CubicBezier curve;
  bool straight = false;         // drawn by L or Z: the curve is straight_bezier
  std::size_t start_vertex = 0;  // index in Path::vertices()
  std::size_t end_vertex = 0;
};

// What lies between one M and the next. A subpath of M alone has no segment.
struct Subpath {
  std::vector<PathSegment> segments;
  std::size_t first_vertex = 0;
  bool closed = false;  // ends in Z; the closing line is the last segment unless it has no length
};

std::vector<Subpath> subpaths(const Path& path);

// The smallest box that holds the path, but for rounding: tighter than Path::control_box.
Box bounding_box(const Path& path);

// The path as one subpath of lines.
Path to_path(const Polyline& polyline);

}  // namespace libstyle
