// SPDX-License-Identifier: Apache-2.0
// What was drawn, as a smooth path of few cubics.
#pragma once

#include <vector>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/geometry/path.h"

namespace libstyle {

struct SmoothCurve {
  Path path;                                  // one subpath
  std::vector<double> lengths;                // along the plain curve, for each vertex of the path
  std::vector<std::vector<double>> features;  // for each feature of the example and each vertex
};

struct FitTolerances {
  double distance = 0;           // px
  std::vector<double> features;  // in units of each
};

// What is not seen where an example is drawn at a scale: a hundredth of a feature size, a fiftieth
// of what there is of a feature.
FitTolerances fit_tolerances(const Example& example, double scale);

// Fits the curve within the tolerances. Corners of the plain curve, which is `total_length` long,
// stay corners: what lies between them is fitted on its own. Points but the ends of these pieces
// are rounded to 1/10000 px, but for pinned ones, which the path has as vertices. There are more
// vertices than the shape needs where features, which change linearly from vertex to vertex, need
// them.
SmoothCurve smooth_curve(const StyledCurve& drawn, double total_length,
                         const FitTolerances& tolerances);

}  // namespace libstyle
