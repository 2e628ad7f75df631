// SPDX-License-Identifier: Apache-2.0
// The basic shapes of SVG 1.1, chapter 9, as paths, from lengths in px. A shape that is not drawn
// (a size of 0 or less) is an empty path. Shapes begin where the standard says, so that dashes fall
// in the same places.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "converters/svg/view_box.h"
#include "libstyle/geometry/path.h"

namespace libstyle::svg {

// A radius that is unset or negative ("auto") is as large as the other one; both are at most half
// of the side.
Path rectangle_path(const Rectangle& rectangle, std::optional<double> radius_x,
                    std::optional<double> radius_y);
Path ellipse_path(Point center, double radius_x, double radius_y);
Path line_path(Point start, Point end);
// One point gives a path of one M, which is not drawn.
Path polyline_path(const std::vector<Point>& points);
Path polygon_path(const std::vector<Point>& points);

// The points attribute. Reads up to the first error; a coordinate without its partner is one, and
// is left out.
struct PointList {
  std::vector<Point> points;
  bool complete = false;
};
PointList parse_points(std::string_view text);

}  // namespace libstyle::svg
