// SPDX-License-Identifier: Apache-2.0
// What was drawn, as a smooth path of few cubics.
#pragma once

#include <vector>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/geometry/path.h"

namespace libstyle {

struct SmoothCurve {
  Path path;                    // one subpath
  std::vector<double> lengths;  // along the plain curve, for each vertex of the path
};

// Fits the curve within `tolerance`. Corners of the plain curve, which is `total_length` long, stay
// corners: what lies between them is fitted on its own. Points but the ends of these pieces are
// rounded to 1/10000 px, but for pinned ones, which the path has as vertices.
SmoothCurve smooth_curve(const StyledCurve& drawn, double total_length, double tolerance);

}  // namespace libstyle
