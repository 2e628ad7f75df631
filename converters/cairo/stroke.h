// SPDX-License-Identifier: Apache-2.0
// Strokes of one width: Cairo's own, with SVG's pens and dots.
#pragma once

#include "converters/cairo/canvas.h"

namespace libstyle {

// Strokes the path of `record` by its style, in `paint` at `opacity`. Nothing is drawn by a pen
// without width, nor by one that its transform has flattened to a line.
void stroke_path(Canvas& canvas, const PathRecord& record, const Paint& paint, double opacity);

}  // namespace libstyle
