// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/paint_source.h"

#include <variant>

#include "converters/cairo/handles.h"

namespace libstyle {
namespace {

void set_color(cairo_t* context, Color color, double opacity) {
  cairo_set_source_rgba(context, color.red / 255.0, color.green / 255.0, color.blue / 255.0,
                        color.alpha / 255.0 * opacity);
}

cairo_extend_t to_cairo(Spread spread) {
  switch (spread) {
    case Spread::kReflect:
      return CAIRO_EXTEND_REFLECT;
    case Spread::kRepeat:
      return CAIRO_EXTEND_REPEAT;
    default:
      return CAIRO_EXTEND_PAD;
  }
}

struct PatternMaker {
  CairoPattern operator()(const LinearGeometry& g) const {
    return CairoPattern(cairo_pattern_create_linear(g.start.x, g.start.y, g.end.x, g.end.y));
  }
  CairoPattern operator()(const RadialGeometry& g) const {
    return CairoPattern(cairo_pattern_create_radial(g.focus.x, g.focus.y, g.focus_radius,
                                                    g.center.x, g.center.y, g.radius));
  }
};

// SVG paints a gradient without extent in its last colour.
bool has_extent(const GradientRecord& gradient) {
  if (const auto* linear = std::get_if<LinearGeometry>(&gradient.geometry)) {
    return linear->start != linear->end;
  }
  return std::get<RadialGeometry>(gradient.geometry).radius > 0;
}

bool set_gradient(Canvas& canvas, const GradientRecord& gradient, double opacity) {
  if (gradient.stops.empty()) return false;
  if (gradient.stops.size() == 1 || !has_extent(gradient)) {
    const GradientStop& last = gradient.stops.back();
    set_color(canvas.context, last.color, last.opacity * opacity);
    return true;
  }
  const auto gradient_from_device = inverse(canvas.device_from_page * gradient.page_from_gradient);
  if (!gradient_from_device) return false;
  const CairoPattern pattern = std::visit(PatternMaker{}, gradient.geometry);
  for (const GradientStop& stop : gradient.stops) {
    cairo_pattern_add_color_stop_rgba(pattern.get(), stop.offset, stop.color.red / 255.0,
                                      stop.color.green / 255.0, stop.color.blue / 255.0,
                                      stop.color.alpha / 255.0 * stop.opacity * opacity);
  }
  cairo_pattern_set_extend(pattern.get(), to_cairo(gradient.spread));
  const cairo_matrix_t matrix = to_cairo(*gradient_from_device);
  cairo_pattern_set_matrix(pattern.get(), &matrix);
  if (cairo_pattern_status(pattern.get()) != CAIRO_STATUS_SUCCESS) return false;
  cairo_set_source(canvas.context, pattern.get());
  return true;
}

}  // namespace

bool set_source(Canvas& canvas, const Paint& paint, double opacity, const RecordBase& user) {
  if (const auto* color = std::get_if<Color>(&paint)) {
    set_color(canvas.context, *color, opacity);
    return true;
  }
  const auto* reference = std::get_if<PaintReference>(&paint);
  if (!reference) return false;
  if (const GradientRecord* gradient = canvas.index.gradient(reference->id)) {
    return set_gradient(canvas, *gradient, opacity);
  }
  canvas.warn_about(user, "the gradient \"" + reference->id + "\" is not there; left unpainted");
  return false;
}

}  // namespace libstyle
