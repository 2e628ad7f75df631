// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/shape_element.h"

#include <algorithm>
#include <cmath>

#include "converters/svg/shapes.h"
#include "libstyle/base/number.h"

namespace libstyle::svg {
namespace {

std::string to_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

// A length is computed from the ends of a path, and rounding may have moved it off the decimal that
// was written: `value` to 12 digits.
double rounded(double value) {
  if (value == 0) return value;
  const double unit = std::pow(10, 11 - std::floor(std::log10(std::abs(value))));
  const double result = std::round(value * unit) / unit;
  return std::isfinite(result) ? result : value;
}

// The length from `low` that ends at `high` when it is added again.
double length_between(double low, double high) {
  const double length = high - low;
  return low + rounded(length) == high ? rounded(length) : length;
}

// What a rectangle element says.
struct RectangleParts {
  Rectangle rectangle;
  double radius_x = 0, radius_y = 0;

  Path path() const { return rectangle_path(rectangle, radius_x, radius_y); }
};

// Those of a path that is a rectangle, of any numbers otherwise. With round corners it begins where
// the first ends, and the last begins ten points before its end.
RectangleParts rectangle_parts(const Path& path) {
  const Box box = path.control_box();
  const auto points = path.points();
  RectangleParts parts = {{box.low.x, box.low.y, length_between(box.low.x, box.high.x),
                           length_between(box.low.y, box.high.y)}};
  if (points.size() > 10) {
    parts.radius_x = length_between(box.low.x, points.front().x);
    parts.radius_y = length_between(box.low.y, points[points.size() - 10].y);
  }
  return parts;
}

std::optional<ShapeElement> rect_element(const Path& path) {
  const RectangleParts parts = rectangle_parts(path);
  if (parts.path() != path) return std::nullopt;
  ShapeElement element = {"rect",
                          {{"x", to_text(parts.rectangle.x)},
                           {"y", to_text(parts.rectangle.y)},
                           {"width", to_text(parts.rectangle.width)},
                           {"height", to_text(parts.rectangle.height)}}};
  if (parts.radius_x > 0) element.attributes.emplace_back("rx", to_text(parts.radius_x));
  if (parts.radius_y > 0) element.attributes.emplace_back("ry", to_text(parts.radius_y));
  return element;
}

struct EllipseParts {
  Point center;
  double radius_x = 0, radius_y = 0;

  Path path() const { return ellipse_path(center, radius_x, radius_y); }
};

// Those of a path that is an ellipse. It begins at its right end and comes to its lower end after
// three pieces.
EllipseParts ellipse_parts(const Path& path) {
  if (path.points().size() < 10) return {};
  const Point right = path.points()[0], bottom = path.points()[9];
  const Point center = {bottom.x, right.y};
  return {center, length_between(center.x, right.x), length_between(center.y, bottom.y)};
}

std::optional<ShapeElement> ellipse_element(const Path& path) {
  const EllipseParts parts = ellipse_parts(path);
  if (parts.path() != path) return std::nullopt;
  return ShapeElement{"ellipse",
                      {{"cx", to_text(parts.center.x)},
                       {"cy", to_text(parts.center.y)},
                       {"rx", to_text(parts.radius_x)},
                       {"ry", to_text(parts.radius_y)}}};
}

std::optional<ShapeElement> circle_element(const Path& path) {
  const EllipseParts parts = ellipse_parts(path);
  for (const double radius : {parts.radius_x, parts.radius_y}) {
    if (ellipse_path(parts.center, radius, radius) != path) continue;
    return ShapeElement{
        "circle",
        {{"cx", to_text(parts.center.x)}, {"cy", to_text(parts.center.y)}, {"r", to_text(radius)}}};
  }
  return std::nullopt;
}

std::optional<ShapeElement> line_element(const Path& path) {
  const auto points = path.points();
  if (points.size() != 2 || line_path(points[0], points[1]) != path) return std::nullopt;
  return ShapeElement{"line",
                      {{"x1", to_text(points[0].x)},
                       {"y1", to_text(points[0].y)},
                       {"x2", to_text(points[1].x)},
                       {"y2", to_text(points[1].y)}}};
}

std::optional<ShapeElement> points_element(std::string_view shape, const Path& path) {
  const std::vector<Point> points(path.points().begin(), path.points().end());
  if ((shape == "polygon" ? polygon_path(points) : polyline_path(points)) != path) {
    return std::nullopt;
  }
  std::string text;
  for (const Point& point : points) {
    if (!text.empty()) text += ' ';
    append_number(text, point.x);
    text += ',';
    append_number(text, point.y);
  }
  return ShapeElement{shape, {{"points", text}}};
}

// The nearest number of a grid on which sums of coordinates within the box are exact.
class Grid {
 public:
  explicit Grid(double size) : step_(std::ldexp(1, std::ilogb(size) - 49)) {}

  double operator()(double value) const { return std::round(value / step_) * step_; }

 private:
  double step_;
};

Path settled_rectangle(const Path& path, const Grid& grid) {
  const auto [rectangle, rx, ry] = rectangle_parts(path);
  const Rectangle settled = {grid(rectangle.x), grid(rectangle.y), grid(rectangle.width),
                             grid(rectangle.height)};
  return rectangle_path(settled, grid(rx), grid(ry));
}

Path settled_ellipse(const Path& path, const Grid& grid, bool circle) {
  const auto [center, radius_x, radius_y] = ellipse_parts(path);
  const double rx = grid(radius_x), ry = circle ? rx : grid(radius_y);
  return ellipse_path({grid(center.x), grid(center.y)}, rx, ry);
}

double largest_coordinate(const Path& path) {
  const Box box = path.control_box();
  return std::max(
      {std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
}

// Whether the points are the same but for rounding.
bool is_near(const Path& a, const Path& b, double size) {
  const auto near = [size](Point p, Point q) {
    return std::abs(p.x - q.x) <= 1e-12 * size && std::abs(p.y - q.y) <= 1e-12 * size;
  };
  return std::ranges::equal(a.commands(), b.commands()) &&
         std::ranges::equal(a.points(), b.points(), near);
}

}  // namespace

std::optional<ShapeElement> shape_element(std::string_view shape, const Path& path) {
  if (path.empty()) return std::nullopt;
  if (shape == "rect") return rect_element(path);
  if (shape == "circle") return circle_element(path);
  if (shape == "ellipse") return ellipse_element(path);
  if (shape == "line") return line_element(path);
  if (shape == "polyline") return points_element("polyline", path);
  if (shape == "polygon") return points_element("polygon", path);
  return std::nullopt;
}

void settle_shape(std::string_view shape, Path& path) {
  const bool circle = shape == "circle";
  if (!circle && shape != "rect" && shape != "ellipse") return;
  if (path.empty() || shape_element(shape, path)) return;
  const double size = largest_coordinate(path);
  const Grid grid(size);
  Path settled =
      shape == "rect" ? settled_rectangle(path, grid) : settled_ellipse(path, grid, circle);
  if (is_near(settled, path, size) && shape_element(shape, settled)) path = std::move(settled);
}

}  // namespace libstyle::svg
