// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/style_attributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <string_view>

#include "libstyle/base/number.h"

namespace libstyle::svg {
namespace {

constexpr std::string_view kCaps[] = {"butt", "round", "square"};
constexpr std::string_view kJoins[] = {"miter", "round", "bevel"};

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Color mean_color(const std::vector<Color>& colors) {
  std::array<double, 4> sums{};
  for (const Color& color : colors) {
    sums[0] += color.red;
    sums[1] += color.green;
    sums[2] += color.blue;
    sums[3] += color.alpha;
  }
  const auto channel = [&](std::size_t i) {
    return static_cast<std::uint8_t>(
        std::floor(sums[i] / static_cast<double>(colors.size()) + 0.5));
  };
  return {channel(0), channel(1), channel(2), channel(3)};
}

// The style with the mean of what varies along the stroke.
Style flattened(const PathRecord& path) {
  Style style = path.style;
  if (style.is_bare()) {
    style.fill = NoPaint{};
    style.stroke = Color{};
  }
  if (!style.stroke || std::holds_alternative<NoPaint>(*style.stroke)) return style;
  const std::vector<double>* widths = path.along.find("width");
  if (widths && !widths->empty()) style.stroke_width = mean(*widths);
  if (!path.along.colors.empty()) style.stroke = mean_color(path.along.colors);
  return style;
}

// Returns what the alpha of the paint takes of its opacity.
double write_paint(XmlWriter& xml, std::string_view name, const std::optional<Paint>& paint,
                   const GradientIds& gradient_ids) {
  if (const auto* color = paint ? std::get_if<Color>(&*paint) : nullptr) {
    xml.attribute(name, to_text({color->red, color->green, color->blue}));
    return color->alpha / 255.0;
  }
  const auto* reference = paint ? std::get_if<PaintReference>(&*paint) : nullptr;
  const std::string id = reference ? gradient_ids(*reference) : "";
  xml.attribute(name, id.empty() ? "none" : "url(#" + id + ")");
  return 1;
}

void write_unless(XmlWriter& xml, std::string_view name, double value, double initial) {
  if (value != initial) xml.attribute(name, value);
}

void write_stroke(XmlWriter& xml, const Style& style, const GradientIds& gradient_ids) {
  const double alpha = style.stroke ? write_paint(xml, "stroke", style.stroke, gradient_ids) : 1;
  write_unless(xml, "stroke-opacity", style.stroke_opacity * alpha, 1);
  write_unless(xml, "stroke-width", style.stroke_width, 1);
  if (style.line_cap != LineCap::kButt) {
    xml.attribute("stroke-linecap", kCaps[static_cast<std::size_t>(style.line_cap)]);
  }
  if (style.line_join != LineJoin::kMiter) {
    xml.attribute("stroke-linejoin", kJoins[static_cast<std::size_t>(style.line_join)]);
  }
  write_unless(xml, "stroke-miterlimit", style.miter_limit, 4);
  if (!style.dash_array.empty()) {
    xml.attribute("stroke-dasharray", to_number_list(style.dash_array, ','));
  }
  write_unless(xml, "stroke-dashoffset", style.dash_offset, 0);
}

}  // namespace

bool varies_along_stroke(const PathRecord& path) {
  const std::vector<double>* widths = path.along.find("width");
  return (widths && !widths->empty()) || !path.along.colors.empty();
}

void write_style(XmlWriter& xml, const PathRecord& path, const GradientIds& gradient_ids) {
  const Style style = flattened(path);
  const double alpha = write_paint(xml, "fill", style.fill, gradient_ids);
  write_unless(xml, "fill-opacity", style.fill_opacity * alpha, 1);
  if (style.fill_rule == FillRule::kEvenOdd) xml.attribute("fill-rule", "evenodd");
  write_stroke(xml, style, gradient_ids);
  if (style.stroke_first) xml.attribute("paint-order", "stroke");
  if (style.crisp_edges) xml.attribute("shape-rendering", "crispEdges");
  write_unless(xml, "opacity", style.opacity, 1);
  if (style.hidden) xml.attribute("visibility", "hidden");
}

std::string to_number_list(std::span<const double> numbers, char separator) {
  std::string text;
  for (const double number : numbers) {
    if (!text.empty()) text += separator;
    append_number(text, number);
  }
  return text;
}

std::string to_matrix(const Transform& transform) {
  const std::array<double, 6> numbers = {transform.a, transform.b, transform.c,
                                         transform.d, transform.e, transform.f};
  return "matrix(" + to_number_list(numbers) + ")";
}

}  // namespace libstyle::svg
