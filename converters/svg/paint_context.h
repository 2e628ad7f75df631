// SPDX-License-Identifier: Apache-2.0
// What `context-fill` and `context-stroke` mean (SVG 2, section 13.2): the paints of the element
// that draws a marker, or of the nearest `use`.
#pragma once

#include "converters/svg/computed_style.h"

namespace libstyle::svg {

// A paint with its opacity. As librsvg has it, the opacity of the context takes the place of that
// of the shape, and a gradient refers to the shape's own box and space.
struct ContextPaint {
  SpecifiedPaint paint;
  double opacity = 1;
};

// No paints outside of any context.
struct PaintContext {
  ContextPaint fill;
  ContextPaint stroke;
};

// The paints of an element drawn in `context`, without references to it and to `color`.
PaintContext paints_of(const ComputedStyle& style, const PaintContext& context);

}  // namespace libstyle::svg
