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

// The first vertex of the whole path is its start and the last its end, all others are between; Z
// is a vertex too. A subpath of M alone has none. A segment of length 0 takes the direction of the
// next that has one, else of the last before, else that of the x axis. The start of a closed
// subpath looks along its first segment, its end halfway between that and the closing line, as
// other programs have it.
std::vector<MarkerVertex> marker_vertices(const Path& path);

}  // namespace libstyle::svg
