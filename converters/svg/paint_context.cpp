// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/paint_context.h"

namespace libstyle::svg {
namespace {

ContextPaint resolved(const SpecifiedPaint& paint, double opacity, const CssColor& color,
                      const PaintContext& context) {
  if (paint.solid.kind == SolidPaint::Kind::kContextFill) return context.fill;
  if (paint.solid.kind == SolidPaint::Kind::kContextStroke) return context.stroke;
  ContextPaint result{paint, opacity};
  if (paint.solid.kind == SolidPaint::Kind::kCurrentColor) {
    result.paint.solid = SolidPaint::of(color);
  }
  return result;
}

}  // namespace

PaintContext paints_of(const ComputedStyle& style, const PaintContext& context) {
  return {resolved(style.fill, style.fill_opacity, style.color, context),
          resolved(style.stroke, style.stroke_opacity, style.color, context)};
}

}  // namespace libstyle::svg
