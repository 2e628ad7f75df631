// SPDX-License-Identifier: Apache-2.0
// Keeps drawings out of Cairo that it would take minutes to fill.
//
// Cairo goes down a picture and holds the edges of a path that cross each line of it in order.
// Where k of them stand side by side it may have to swap up to k^2 / 2 of them before the next
// line, so a scribble of a hundred thousand lines across a page takes a minute, and one of ten
// million a week. The measure here is the sum of k^2 over the rows of pixels. Many short lines,
// such as a coast of millions of points, keep k small and count for nothing.
#pragma once

#include "converters/cairo/canvas.h"

namespace libstyle {

// In all the paths of a document. Cairo does 1e10 to 1e11 of them a second (scribbles and hatchings
// of 10^3 to 10^6 lines, 200 and 1000 px high).
constexpr double kMostEdgePairs = 1e12;

// The sum over the rows of pixels in `window` of the square of the number of segments there. Curves
// count as the lines between their control points.
double edge_pairs(const Path& path, const Transform& device_from_path, const Box& window);

// Notes that a path is about to be filled, or stroked, where each segment has `edges_per_segment`
// long edges. Throws Error when the document comes to more than kMostEdgePairs; never on surfaces
// that are not made of pixels.
void count_edges(Canvas& canvas, const Path& path, const Transform& device_from_path,
                 double edges_per_segment);

}  // namespace libstyle
