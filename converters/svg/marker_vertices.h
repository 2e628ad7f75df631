// SPDX-License-Identifier: Apache-2.0
// Where markers stand on a path, and which way they look (SVG 1.1, section 11.6.3).
#pragma once

#include <cstdint>
#include <vector>

#include "libstyle/geometry/path.h"

namespace libstyle::svg {

enum class MarkerPlace : std::uint8_t { kStart, kMid, kEnd };

struct MarkerVertex {
  MarkerPlace place = MarkerPlace::kMid;
  Point position;
  Vector direction;  // of length 1: along the path, or halfway between arriving and leaving
};

// As librsvg counts them, which differs from SVG 1.1 where a path has several subpaths. Each
// segment is a vertex at its start, the closing line even where it has no length; the first is the
// start of the path, and so is the first after a lone M, which is a vertex between that looks along
// the x axis. The end of the last segment is the end of the path; the ends of other subpaths are no
// vertices. Segments without length have no direction; vertices look halfway between the last
// direction before them and the next after them.
std::vector<MarkerVertex> marker_vertices(const Path& path);

}  // namespace libstyle::svg
