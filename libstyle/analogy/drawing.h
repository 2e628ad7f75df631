// SPDX-License-Identifier: Apache-2.0
// A whole drawing in the style of an example.
#pragma once

#include <cstddef>
#include <span>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/base/progress.h"
#include "libstyle/base/warning.h"
#include "libstyle/curves/document.h"

namespace libstyle {

struct DrawingOptions {
  int threads = 0;  // 0: one a core; does not change the result
  ProgressHandler progress;
  WarningHandler warn;
};

// Draws every subpath of every path record again; all else stays. The outcome is smooth paths of
// few cubics, with the corners of the drawing and of the style kept, within a hundredth of a
// feature size. Values along the curves are carried to the new vertices. Paths that are the same
// curve, such as a filling and its outline, are drawn alike. Coordinates are rounded to 1/10000 px
// except where curves begin and end. Lines that met, at their ends or one with the middle of
// another, still meet.
//
// Warns of curves that are too long for the style, and when most of the drawing had to be drawn
// with the style at less than half its size.
void draw_again(Document& document, const CurveAnalogy& style, const DrawingOptions& options);

// The scale at which the style has room: about three times what the lines of the drawing need at
// the least, by the median over their length. 1 for a drawing without lines. Lines go from corner
// to corner.
double fitting_scale(const Document& document, std::span<const ExamplePair> pairs,
                     const CurveAnalogyParameters& parameters);

}  // namespace libstyle
