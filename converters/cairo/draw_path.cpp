// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/draw_path.h"

#include "converters/cairo/clip.h"
#include "converters/cairo/ink.h"
#include "converters/cairo/layer.h"
#include "converters/cairo/paint_source.h"
#include "converters/cairo/stroke.h"
#include "converters/cairo/trace.h"
#include "converters/cairo/varying_stroke.h"

namespace libstyle {
namespace {

void draw_fill(Canvas& canvas, const PathRecord& record, double opacity) {
  const Style& style = record.style;
  if (!style.fill || !set_source(canvas, *style.fill, style.fill_opacity * opacity, record)) return;
  cairo_new_path(canvas.context);
  trace_fill(canvas, record.path);
  cairo_set_fill_rule(canvas.context, to_cairo(style.fill_rule));
  cairo_fill(canvas.context);
}

void draw_stroke(Canvas& canvas, const PathRecord& record, double opacity) {
  if (!has_stroke(record)) return;
  const Paint paint = record.style.stroke.value_or(Color{});
  const double whole = record.style.stroke_opacity * opacity;
  if (varies_along(record)) {
    draw_varying_stroke(canvas, record, paint, whole);
  } else {
    stroke_path(canvas, record, paint, whole);
  }
}

void draw_fill_and_stroke(Canvas& canvas, const PathRecord& record, double opacity) {
  if (record.style.stroke_first) draw_stroke(canvas, record, opacity);
  draw_fill(canvas, record, opacity);
  if (!record.style.stroke_first) draw_stroke(canvas, record, opacity);
}

bool has_fill(const PathRecord& record) {
  return record.style.fill && !std::holds_alternative<NoPaint>(*record.style.fill);
}

}  // namespace

// A layer is needed only where fill and stroke would show through each other.
void draw_path(Canvas& canvas, const PathRecord& record, const Box& ink) {
  const double opacity = record.style.opacity;
  if (ink.empty() || opacity <= 0) return;
  ClipScope clip(canvas, record.clip, record);
  const bool crisp = record.style.crisp_edges;
  cairo_set_antialias(canvas.context, crisp ? CAIRO_ANTIALIAS_NONE : CAIRO_ANTIALIAS_DEFAULT);
  if (opacity < 1 && has_fill(record) && has_stroke(record)) {
    begin_layer_over(canvas, ink);
    draw_fill_and_stroke(canvas, record, 1);
    draw_layer(canvas, opacity);
  } else {
    draw_fill_and_stroke(canvas, record, opacity);
  }
  cairo_set_antialias(canvas.context, CAIRO_ANTIALIAS_DEFAULT);
  clip.end();
}

}  // namespace libstyle
