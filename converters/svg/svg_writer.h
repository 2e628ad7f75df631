// SPDX-License-Identifier: Apache-2.0
// Writes one document of curves as an SVG file that draws the same and that people can edit.
//
// - Groups and elements nest again; layers are layers of Inkscape; ids, classes, labels and data-*
//   attributes are what they were. Ids made by a program lose their "~" part (record_ids.h).
// - A path is the basic shape that it was drawn as where that gives the same curve to the last bit.
// - Paint stands in attributes; gradients and clips in <defs>.
// - The page has its original unit, and a viewBox in px, which the coordinates are in.
// - A pen that is no circle is written as a transform of its path, whose coordinates are then those
//   of the pen; those on the page stand beside them where rounding would change them (pen_space.h).
//
// What SVG has no place for stands beside it (carried_keys.h): nothing is lost. What SVG cannot
// draw, a stroke that varies along its curve, is drawn with its mean; that is warned about once.
#pragma once

#include "libstyle/base/bytes.h"
#include "libstyle/base/warning.h"
#include "libstyle/curves/document.h"

namespace libstyle::svg {

// Each kind of warning is given once, with the first record it concerns.
void write_svg(ByteSink& sink, const Document& document, const WarningHandler& warn);

}  // namespace libstyle::svg
