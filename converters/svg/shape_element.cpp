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
// was written: the same to 12 digits, and as computed.
std::vector<double> candidates(double value) {
  if (value == 0) return {value};
  const double unit = std::pow(10, 11 - std::floor(std::log10(std::abs(value))));
  const double rounded = std::round(value * unit) / unit;
  if (!std::isfinite(rounded) || rounded == value) return {value};
  return {rounded, value};
}

std::vector<std::pair<double, double>> candidate_pairs(double first, double second) {
  std::vector<std::pair<double, double>> pairs;
  for (const double a : candidates(first)) {
    for (const double b : candidates(second)) pairs.emplace_back(a, b);
  }
  return pairs;
}

// The corner radii if the path is a rectangle with round corners: it then begins where the corner
// ends.
std::vector<std::pair<double, double>> candidate_radii(const Path& path, const Box& box) {
  if (path.commands().size() <= 5) return {{0, 0}};
  const auto points = path.points();
  const double radius_x = points.front().x - box.low.x;
  const double radius_y = points[points.size() - 10].y - box.low.y;
  return candidate_pairs(radius_x, radius_y);
}

std::optional<ShapeElement> rect_element(const Path& path) {
  if (path.points().size() < 4) return std::nullopt;
  const Box box = path.control_box();
  for (const auto& [width, height] : candidate_pairs(box.width(), box.height())) {
    for (const auto& [rx, ry] : candidate_radii(path, box)) {
      if (rectangle_path({box.low.x, box.low.y, width, height}, rx, ry) != path) continue;
      ShapeElement element = {"rect",
                              {{"x", to_text(box.low.x)},
                               {"y", to_text(box.low.y)},
                               {"width", to_text(width)},
                               {"height", to_text(height)}}};
      if (rx > 0) element.attributes.emplace_back("rx", to_text(rx));
      if (ry > 0) element.attributes.emplace_back("ry", to_text(ry));
      return element;
    }
  }
  return std::nullopt;
}

// The centre and the radius, along one axis, that give this low and high edge.
std::optional<std::pair<double, double>> centered(double low, double high) {
  for (const auto& [center, radius] : candidate_pairs(low + (high - low) / 2, (high - low) / 2)) {
    if (center - radius == low && center + radius == high) return std::pair(center, radius);
  }
  return std::nullopt;
}

std::optional<ShapeElement> ellipse_element(std::string_view shape, const Path& path) {
  const Box box = path.control_box();
  const auto x = centered(box.low.x, box.high.x), y = centered(box.low.y, box.high.y);
  if (!x || !y || ellipse_path({x->first, y->first}, x->second, y->second) != path) {
    return std::nullopt;
  }
  ShapeElement element = {shape, {{"cx", to_text(x->first)}, {"cy", to_text(y->first)}}};
  if (shape == "circle") {
    if (x->second != y->second) return std::nullopt;
    element.attributes.emplace_back("r", to_text(x->second));
  } else {
    element.attributes.emplace_back("rx", to_text(x->second));
    element.attributes.emplace_back("ry", to_text(y->second));
  }
  return element;
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

}  // namespace

std::optional<ShapeElement> shape_element(std::string_view shape, const Path& path) {
  if (path.empty()) return std::nullopt;
  if (shape == "rect") return rect_element(path);
  if (shape == "circle") return ellipse_element("circle", path);
  if (shape == "ellipse") return ellipse_element("ellipse", path);
  if (shape == "line") return line_element(path);
  if (shape == "polyline") return points_element("polyline", path);
  if (shape == "polygon") return points_element("polygon", path);
  return std::nullopt;
}

}  // namespace libstyle::svg
