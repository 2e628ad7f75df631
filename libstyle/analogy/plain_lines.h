// SPDX-License-Identifier: Apache-2.0
// A curve as the lines between its corners.
#pragma once

#include <optional>
#include <vector>

#include "libstyle/geometry/polyline.h"

namespace libstyle {

struct PlainLine {
  Polyline line;             // has a length; closed only if it is the whole of a closed curve
  double length_before = 0;  // along the curve, up to the beginning of the line
  bool starts_at_corner = false;
};

// The lines one after the other, none of zero length; nothing for a curve without length. A closed
// curve with corners begins at its first corner, and the last line ends there.
// `corner_angle`: turns sharper than this, in radians, are corners; unset: there are none.
// `reach`: over how much length a turn is looked at, at most; > 0.
std::vector<PlainLine> split_into_lines(const Polyline& curve, std::optional<double> corner_angle,
                                        double reach);

}  // namespace libstyle
