// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/shapes.h"

#include <algorithm>

#include "converters/svg/arc.h"
#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

// A side that the round corners leave nothing of is left out.
void append_side(Path& path, Point end) {
  if (path.points().back() != end) path.line_to(end);
}

Path sharp_rectangle(Point low, Point high) {
  Path path;
  path.move_to(low);
  path.line_to({high.x, low.y});
  path.line_to(high);
  path.line_to({low.x, high.y});
  path.close();
  return path;
}

}  // namespace

Path rectangle_path(const Rectangle& rectangle, std::optional<double> radius_x,
                    std::optional<double> radius_y) {
  if (!(rectangle.width > 0 && rectangle.height > 0)) return {};
  if (radius_x && *radius_x < 0) radius_x.reset();
  if (radius_y && *radius_y < 0) radius_y.reset();
  const double rx = std::min(radius_x.value_or(radius_y.value_or(0)), rectangle.width / 2);
  const double ry = std::min(radius_y.value_or(radius_x.value_or(0)), rectangle.height / 2);
  const Point low = {rectangle.x, rectangle.y};
  const Point high = {rectangle.x + rectangle.width, rectangle.y + rectangle.height};
  if (rx == 0 || ry == 0) return sharp_rectangle(low, high);

  Path path;
  path.move_to({low.x + rx, low.y});
  append_side(path, {high.x - rx, low.y});
  append_quarter(path, {high.x - rx, low.y}, {high.x, low.y}, {high.x, low.y + ry});
  append_side(path, {high.x, high.y - ry});
  append_quarter(path, {high.x, high.y - ry}, high, {high.x - rx, high.y});
  append_side(path, {low.x + rx, high.y});
  append_quarter(path, {low.x + rx, high.y}, {low.x, high.y}, {low.x, high.y - ry});
  append_side(path, {low.x, low.y + ry});
  append_quarter(path, {low.x, low.y + ry}, low, {low.x + rx, low.y});
  path.close();
  return path;
}

Path ellipse_path(Point center, double radius_x, double radius_y) {
  if (!(radius_x > 0 && radius_y > 0)) return {};
  const Point low = {center.x - radius_x, center.y - radius_y};
  const Point high = {center.x + radius_x, center.y + radius_y};
  Path path;
  path.move_to({high.x, center.y});
  append_quarter(path, {high.x, center.y}, high, {center.x, high.y});
  append_quarter(path, {center.x, high.y}, {low.x, high.y}, {low.x, center.y});
  append_quarter(path, {low.x, center.y}, low, {center.x, low.y});
  append_quarter(path, {center.x, low.y}, {high.x, low.y}, {high.x, center.y});
  path.close();
  return path;
}

Path line_path(Point start, Point end) {
  Path path;
  path.move_to(start);
  path.line_to(end);
  return path;
}

Path polyline_path(const std::vector<Point>& points) {
  Path path;
  path.reserve(points.size() + 1, points.size());
  for (const Point& point : points) {
    if (path.empty()) {
      path.move_to(point);
    } else {
      path.line_to(point);
    }
  }
  return path;
}

Path polygon_path(const std::vector<Point>& points) {
  Path path = polyline_path(points);
  if (!path.empty()) path.close();
  return path;
}

// As librsvg reads them: after a point comes white space, or one sign or number that is passed
// over, and then maybe a comma. So "1,1,,2,2" is right, "1-1-2 2" and "1 1 , 2 2" are not.
PointList parse_points(std::string_view text) {
  PointList result;
  Scanner scanner(trimmed(text));
  while (!scanner.at_end()) {
    Point point;
    scanner.skip_spaces();
    if (!scanner.take_css_number(point.x)) return result;
    scanner.skip_separator();
    if (!scanner.take_css_number(point.y)) return result;
    result.points.push_back(point);
    if (scanner.at_end() || is_space(scanner.peek())) continue;
    double passed_over = 0;
    if (!scanner.take_css_number(passed_over)) scanner.advance();
    scanner.skip_separator();
    if (scanner.at_end()) return result;
  }
  result.complete = true;
  return result;
}

}  // namespace libstyle::svg
