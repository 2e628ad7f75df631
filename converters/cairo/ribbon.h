// SPDX-License-Identifier: Apache-2.0
// A path whose stroke changes along it, as points on the device.
#pragma once

#include <array>
#include <vector>

#include "converters/cairo/dash_pattern.h"
#include "libstyle/curves/document.h"

namespace libstyle {

struct RibbonPoint {
  Point place;
  double radius = 0;              // half the width
  std::array<double, 4> color{};  // red, green, blue, alpha, 0 .. 1
};

struct Ribbon {
  std::vector<RibbonPoint> points;    // no two neighbours at one place
  bool closed = false;                // also joins the last point to the first
  Vector start_tangent, end_tangent;  // of the curve; {0, 0}: as the first and last lines
};

// All of `a` at 0, all of `b` at 1.
RibbonPoint lerp(const RibbonPoint& a, const RibbonPoint& b, double t);

// Flattens the subpaths of `record`. Between two vertices width and colour change evenly with the
// length of the curve; a closing line leads from the last vertex's values to the first's.
std::vector<Ribbon> make_ribbons(const PathRecord& record, const Transform& device_from_page);

// Cuts ribbons into their dashes, the pattern in device px. They stay whole when they would come to
// more than kMostDashes.
std::vector<Ribbon> cut_dashes(std::vector<Ribbon> ribbons, const DashPattern& pattern);

}  // namespace libstyle
