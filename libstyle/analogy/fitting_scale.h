// SPDX-License-Identifier: Apache-2.0
// How large a style may be in a drawing.
#pragma once

#include <span>

#include "libstyle/analogy/example.h"
#include "libstyle/analogy/parameters.h"
#include "libstyle/geometry/path.h"

namespace libstyle {

// The scale at which the style has room: about three times what the lines of the paths need at the
// least, by the median over their length. 1 if there are no lines. Lines go from corner to corner.
double fitting_scale(std::span<const Path* const> paths, std::span<const ExamplePair> pairs,
                     const CurveAnalogyParameters& parameters);

}  // namespace libstyle
