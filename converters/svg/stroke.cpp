// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/stroke.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace libstyle::svg {
namespace {

// Relative; well above the rounding of a chain of transforms, well below what an eye could see.
constexpr double kShapeTolerance = 1e-9;

// An odd list is repeated once, so that dashes and gaps alternate. All zeros mean no dashes.
std::vector<double> resolved_dashes(const ComputedStyle& computed, const LengthContext& context,
                                    double scale) {
  std::vector<double> dashes;
  for (const Length dash : computed.dash_array) {
    dashes.push_back(scale * resolve(dash, LengthAxis::kDiagonal, context));
  }
  const bool drawn = std::ranges::any_of(dashes, [](double dash) { return dash > 0; });
  if (!drawn) return {};
  const std::size_t count = dashes.size();
  if (count % 2 == 1) {
    for (std::size_t i = 0; i < count; ++i) dashes.push_back(dashes[i]);
  }
  return dashes;
}

bool is_finite(const Style& style) {
  return std::isfinite(style.stroke_width) && std::isfinite(style.dash_offset) &&
         std::ranges::all_of(style.dash_array, [](double dash) { return std::isfinite(dash); }) &&
         (!style.stroke_transform || style.stroke_transform->is_finite());
}

}  // namespace

std::optional<double> uniform_scale(const Transform& map) {
  const double size =
      std::max({std::abs(map.a), std::abs(map.b), std::abs(map.c), std::abs(map.d)});
  const double tolerance = kShapeTolerance * size;
  const auto near = [&](double a, double b) { return std::abs(a - b) <= tolerance; };
  const bool turned = near(map.a, map.d) && near(map.b, -map.c);
  const bool mirrored = near(map.a, -map.d) && near(map.b, map.c);
  if (!turned && !mirrored) return std::nullopt;
  // An even scale of 1 or 2 stays exactly that.
  return map.b == 0 ? std::abs(map.a) : norm({map.a, map.b});
}

bool set_stroke_geometry(Style& style, const ComputedStyle& computed, const LengthContext& context,
                         const Transform& page_from_user) {
  Style pen = style;
  const std::optional<double> uniform = uniform_scale(page_from_user);
  const double scale = uniform.value_or(1);
  if (!uniform) {
    pen.stroke_transform = page_from_user;
    pen.stroke_transform->e = pen.stroke_transform->f = 0;
  }
  const double width = resolve(computed.stroke_width, LengthAxis::kDiagonal, context);
  pen.stroke_width = scale * std::max(0.0, width);  // a negative width draws nothing
  pen.line_cap = computed.line_cap;
  pen.line_join = computed.line_join;
  pen.miter_limit = computed.miter_limit;
  pen.dash_array = resolved_dashes(computed, context, scale);
  pen.dash_offset = pen.dash_array.empty()
                        ? 0
                        : scale * resolve(computed.dash_offset, LengthAxis::kDiagonal, context);
  if (!is_finite(pen)) return false;
  style = std::move(pen);
  return true;
}

}  // namespace libstyle::svg
