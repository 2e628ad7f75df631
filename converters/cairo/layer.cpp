// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/layer.h"

#include <algorithm>
#include <cmath>

namespace libstyle {
namespace {

constexpr std::size_t kMostLayers = 1000;
constexpr double kMostBytes = 1 << 30;

cairo_operator_t to_cairo(BlendMode mode) {
  constexpr cairo_operator_t kOperators[] = {
      CAIRO_OPERATOR_OVER,          CAIRO_OPERATOR_MULTIPLY,       CAIRO_OPERATOR_SCREEN,
      CAIRO_OPERATOR_OVERLAY,       CAIRO_OPERATOR_DARKEN,         CAIRO_OPERATOR_LIGHTEN,
      CAIRO_OPERATOR_COLOR_DODGE,   CAIRO_OPERATOR_COLOR_BURN,     CAIRO_OPERATOR_HARD_LIGHT,
      CAIRO_OPERATOR_SOFT_LIGHT,    CAIRO_OPERATOR_DIFFERENCE,     CAIRO_OPERATOR_EXCLUSION,
      CAIRO_OPERATOR_HSL_HUE,       CAIRO_OPERATOR_HSL_SATURATION, CAIRO_OPERATOR_HSL_COLOR,
      CAIRO_OPERATOR_HSL_LUMINOSITY};
  return kOperators[static_cast<std::size_t>(mode)];
}

double layer_bytes(cairo_t* context) {
  double left = 0, top = 0, right = 0, bottom = 0;
  cairo_clip_extents(context, &left, &top, &right, &bottom);
  return 4 * (right - left) * (bottom - top);
}

}  // namespace

void begin_layer(Canvas& canvas, cairo_content_t content) {
  canvas.layer_bytes.push_back(layer_bytes(canvas.context));
  double total = 0;
  for (const double bytes : canvas.layer_bytes) total += bytes;
  if (canvas.layer_bytes.size() > kMostLayers || total > kMostBytes) {
    throw Error(
        "groups with opacity or clips are too deep within each other for a picture of "
        "this size; flatten the groups or draw it smaller");
  }
  cairo_push_group_with_content(canvas.context, content);
}

CairoPattern end_layer(Canvas& canvas) {
  canvas.layer_bytes.pop_back();
  return CairoPattern(cairo_pop_group(canvas.context));
}

void begin_layer_over(Canvas& canvas, const Box& ink) {
  const Box box = transformed(ink, canvas.device_from_page);
  const double left = std::floor(std::max(box.low.x, canvas.window.low.x));
  const double top = std::floor(std::max(box.low.y, canvas.window.low.y));
  const double right = std::ceil(std::min(box.high.x, canvas.window.high.x));
  const double bottom = std::ceil(std::min(box.high.y, canvas.window.high.y));
  cairo_save(canvas.context);
  cairo_new_path(canvas.context);
  cairo_rectangle(canvas.context, left, top, std::max(0.0, right - left),
                  std::max(0.0, bottom - top));
  cairo_clip(canvas.context);
  begin_layer(canvas);
}

void draw_layer(Canvas& canvas, double opacity, BlendMode mode) {
  const CairoPattern layer = end_layer(canvas);
  cairo_set_source(canvas.context, layer.get());
  cairo_set_operator(canvas.context, to_cairo(mode));
  cairo_paint_with_alpha(canvas.context, opacity);
  cairo_restore(canvas.context);
}

}  // namespace libstyle
