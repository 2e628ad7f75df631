// SPDX-License-Identifier: Apache-2.0
// Angles in degrees.
#pragma once

#include <optional>
#include <string_view>

#include "libstyle/geometry/point.h"

namespace libstyle::svg {

// (cos, sin) of an angle: exact at multiples of 90 degrees, else within 2.3e-16. The same on every
// machine, which std::cos and std::sin are not in the last digit. `degrees` is finite.
Vector unit_vector_at(double degrees);

// How many degrees a CSS unit is: deg, grad, rad, turn, in any case. Nothing for others.
std::optional<double> degrees_per_unit(std::string_view unit);

// As above without turns, which librsvg knows in colours alone.
std::optional<double> degrees_per_svg_unit(std::string_view unit);

}  // namespace libstyle::svg
