// SPDX-License-Identifier: Apache-2.0
// Strokes whose width or colour changes along the curve.
//
// The stroke is one outline, filled once, so that it shows neither gaps nor overlaps at any
// opacity: a four-sided piece for every flattened line, neighbours sharing their edge where the
// curve is smooth, and a disc wherever they cannot (corners, round ends). A piece whose ends cross,
// in a turn tighter than its radius, is the two triangles that they sweep.
// All pieces turn the same way, so the non-zero rule makes their union. Colours are a mesh gradient
// under the outline. Joins are always round; caps, dashes and opacity are those of the style; the
// transform of a pen is not followed.
#pragma once

#include "converters/cairo/canvas.h"

namespace libstyle {

// Whether a path has widths or colours along it.
bool varies_along(const PathRecord& record);

// Draws the stroke. Colours along the curve, if any, stand for `paint`.
void draw_varying_stroke(Canvas& canvas, const PathRecord& record, const Paint& paint,
                         double opacity);

}  // namespace libstyle
