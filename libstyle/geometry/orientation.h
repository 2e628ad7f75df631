// SPDX-License-Identifier: Apache-2.0
// On which side of a line a point lies, exactly.
#pragma once

#include "libstyle/geometry/point.h"

namespace libstyle {

// The sign, -1, 0 or 1, of cross(b - a, c - a): 1 when a, b, c turn clockwise on a page with y
// down, 0 only when the three points are exactly in line. Right for all coordinates whose products
// neither overflow nor underflow (magnitudes 0 and 1e-140 .. 1e150).
//
// Source: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates", 1997: a bound on the rounding error settles nearly all cases; the others are summed
// without error as an expansion.
int orientation(Point a, Point b, Point c);

}  // namespace libstyle
