// SPDX-License-Identifier: Apache-2.0
// More vertices for a fitted path, where what goes along it needs them.
#pragma once

#include <span>
#include <vector>

#include "libstyle/geometry/cubic_fit.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

// Between vertices values change linearly with the parameter of the segment. Segments are cut where
// that errs most, as in the Douglas-Peucker algorithm, until no point of the fitted curve has a
// value that is off by more than its tolerance. The shape stays as it is. `features` has a row for
// each feature, with one value for each point of the curve; `tolerances` has one, >= 0, for each
// row.
CubicFit with_feature_vertices(CubicFit fit, const Polyline& curve,
                               std::span<const std::vector<double>> features,
                               std::span<const double> tolerances);

}  // namespace libstyle
