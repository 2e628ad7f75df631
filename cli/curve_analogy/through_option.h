// SPDX-License-Identifier: Apache-2.0
// The value of --through of curve-analogy: CURVE=X,Y@T*WEIGHT.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libstyle/analogy/curve_constraint.h"
#include "libstyle/analogy/drawing_constraints.h"

namespace libstyle {

// "@T" and "*WEIGHT" may be left out. What stands before the last = is the id. Throws UsageError.
AskedConstraint parse_through_option(std::string_view text);

// For a line that is yet to be made: X,Y@T*WEIGHT, where "*WEIGHT" may be left out. Throws
// UsageError.
CurveConstraint parse_through_option_of_new_line(std::string_view text);

}  // namespace libstyle
