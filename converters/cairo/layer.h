// SPDX-License-Identifier: Apache-2.0
// Layers: pictures within the picture, drawn aside to be put down as one (Cairo's groups).
#pragma once

#include "converters/cairo/canvas.h"
#include "converters/cairo/handles.h"

namespace libstyle {

// Draws aside, over the extent of the current clip, until the matching end_layer. Throws Error when
// layers are open so deep that they would hold over a gigabyte.
void begin_layer(Canvas& canvas, cairo_content_t content = CAIRO_CONTENT_COLOR_ALPHA);

// What the innermost layer holds.
CairoPattern end_layer(Canvas& canvas);

// A layer as large as what it will hold, which is known beforehand, and its end: small layers on a
// large picture cost little.
void begin_layer_over(Canvas& canvas, const Box& ink);
void draw_layer(Canvas& canvas, double opacity, BlendMode mode = BlendMode::kNormal);

}  // namespace libstyle
