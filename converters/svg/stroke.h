// SPDX-License-Identifier: Apache-2.0
// The pen of a stroke, brought from an element's user space to the page.
#pragma once

#include "converters/svg/computed_style.h"
#include "libstyle/curves/style.h"

namespace libstyle::svg {

// The factor of lengths, if the map keeps shapes (turns, mirrors and scales evenly).
std::optional<double> uniform_scale(const Transform& map);

// Sets width, caps, joins, miter limit and dashes. An even scale goes into the lengths; any other
// map is kept as the space of the pen. Says no when a length is too large for a number.
bool set_stroke_geometry(Style& style, const ComputedStyle& computed, const LengthContext& context,
                         const Transform& page_from_user);

}  // namespace libstyle::svg
