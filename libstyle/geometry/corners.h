// SPDX-License-Identifier: Apache-2.0
// Corners of a polyline: where a pen stopped and set off in another direction.
//
// A corner is told from a tight bend and from the noise of a shaky hand by the company it keeps.
// For each vertex whose chords over `reach` before and after turn sharply, and more so than those
// of its neighbours, two models with as many unknowns are fitted to the curve within reach: two
// straight pieces that meet at the vertex, and a parabola. It is a corner if the pieces fit better
// and turn by more than `angle`.
//
// Cost: O(n log n).
#pragma once

#include <cstddef>
#include <vector>

#include "libstyle/geometry/polyline.h"

namespace libstyle {

struct CornerParams {
  double angle = 0.7853981633974483;  // the least turn of a corner, radians, 0 .. pi; 45 degrees
  double reach = 2;                   // arc length looked at on either side, > 0, curve's units
};

// The indices of the corners, rising; where points repeat, the first of them. Ends of an open
// polyline are not corners, nor is what is nearer to them than a quarter of the reach.
// Throws Error when a parameter is out of range or a point is not finite.
std::vector<std::size_t> find_corners(const Polyline& polyline, const CornerParams& params = {});

}  // namespace libstyle
