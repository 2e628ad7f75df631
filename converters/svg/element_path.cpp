// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/element_path.h"

#include <optional>
#include <string>

#include "converters/svg/path_grammar.h"
#include "converters/svg/scanner.h"
#include "converters/svg/shapes.h"

namespace libstyle::svg {
namespace {

// Lengths of one element in px.
class Resolver {
 public:
  explicit Resolver(const LengthContext& context) : context_(context) {}

  double horizontal(Length length) const {
    return resolve(length, LengthAxis::kHorizontal, context_);
  }
  double vertical(Length length) const { return resolve(length, LengthAxis::kVertical, context_); }
  double diagonal(Length length) const { return resolve(length, LengthAxis::kDiagonal, context_); }
  std::optional<double> horizontal(std::optional<Length> length) const {
    if (!length) return std::nullopt;
    return horizontal(*length);
  }
  std::optional<double> vertical(std::optional<Length> length) const {
    if (!length) return std::nullopt;
    return vertical(*length);
  }

 private:
  LengthContext context_;
};

Path rectangle(const ComputedStyle& style, const Resolver& px) {
  const Rectangle rectangle{px.horizontal(style.x), px.vertical(style.y),
                            px.horizontal(style.width).value_or(0),
                            px.vertical(style.height).value_or(0)};
  return rectangle_path(rectangle, px.horizontal(style.radius_x), px.vertical(style.radius_y));
}

Path circle(const ComputedStyle& style, const Resolver& px) {
  const double radius = px.diagonal(style.radius);
  return ellipse_path({px.horizontal(style.center_x), px.vertical(style.center_y)}, radius, radius);
}

// A radius that is "auto" is as large as the other one.
Path ellipse(const ComputedStyle& style, const Resolver& px) {
  const std::optional<double> x = px.horizontal(style.radius_x);
  const std::optional<double> y = px.vertical(style.radius_y);
  return ellipse_path({px.horizontal(style.center_x), px.vertical(style.center_y)},
                      x.value_or(y.value_or(0)), y.value_or(x.value_or(0)));
}

// The ends of a line are no properties: one that is wrong is an error, and the line is not drawn.
Path line(pugi::xml_node element, const Resolver& px) {
  bool wrong = false;
  const auto length = [&](const char* name) {
    const pugi::xml_attribute attribute = element.attribute(name);
    const std::optional<Length> given =
        attribute ? parse_leading_length(attribute.value()) : Length{};
    wrong = wrong || !given;
    return given.value_or(Length{});
  };
  const Path path = line_path({px.horizontal(length("x1")), px.vertical(length("y1"))},
                              {px.horizontal(length("x2")), px.vertical(length("y2"))});
  return wrong ? Path() : path;
}

Path points(pugi::xml_node element, ElementKind kind, Reporter& reporter) {
  const PointList list = parse_points(element.attribute("points").value());
  if (!list.complete) {
    reporter.warn(element, "its list of points has an error; it is left out");
    return {};
  }
  return kind == ElementKind::kPolygon ? polygon_path(list.points) : polyline_path(list.points);
}

Path path(pugi::xml_node element, std::size_t point_limit, Reporter& reporter) {
  ParsedPath parsed = parse_path_grammar(element.attribute("d").value(), point_limit);
  const bool over = parsed.path.points().size() > point_limit;
  if (parsed.error_at && !over) {
    reporter.warn(element, "its path data has an error at character " +
                               std::to_string(*parsed.error_at + 1) + "; it is drawn up to there");
  }
  return std::move(parsed.path);
}

// A length that is none counts as not given, which is seldom what was meant.
void warn_wrong_lengths(pugi::xml_node element, Reporter& reporter) {
  for (const char* name :
       {"x", "y", "width", "height", "cx", "cy", "r", "rx", "ry", "x1", "y1", "x2", "y2"}) {
    const pugi::xml_attribute attribute = element.attribute(name);
    const std::string_view value = trimmed(attribute.value());
    if (value.empty() || value == "auto" || value == "inherit" || parse_leading_length(value))
      continue;
    return reporter.warn(element,
                         std::string(name) + " is no length: \"" + std::string(value) + '"');
  }
}

}  // namespace

LengthContext length_context(const ComputedStyle& style, const Vector& viewport) {
  return {viewport.x, viewport.y, style.font_size};
}

Path element_path(pugi::xml_node element, ElementKind kind, const ComputedStyle& style,
                  const Vector& viewport, std::size_t point_limit, Reporter& reporter) {
  if (kind != ElementKind::kPath) warn_wrong_lengths(element, reporter);
  const Resolver px(length_context(style, viewport));
  switch (kind) {
    case ElementKind::kRect:
      return rectangle(style, px);
    case ElementKind::kCircle:
      return circle(style, px);
    case ElementKind::kEllipse:
      return ellipse(style, px);
    case ElementKind::kLine:
      return line(element, px);
    case ElementKind::kPolyline:
    case ElementKind::kPolygon:
      return points(element, kind, reporter);
    case ElementKind::kPath:
      return path(element, point_limit, reporter);
    default:
      return {};
  }
}

}  // namespace libstyle::svg
