// SPDX-License-Identifier: Apache-2.0
// The value of the transform attribute and of the CSS property of the same name.
#pragma once

#include <optional>
#include <string_view>

#include "libstyle/geometry/transform.h"

namespace libstyle::svg {

// "translate(10,20) rotate(45 5 5)": matrix, translate, scale, rotate, skewX and skewY with plain
// numbers, separated by white space and commas. Empty text is the identity. Nothing when any part
// is wrong: one fault makes the whole list invalid, and the element is drawn as if it had none.
std::optional<Transform> parse_transform_attribute(std::string_view text);

// "translate(10px, 20px) rotate(45deg)": arguments separated by commas, lengths in px, angles with
// units or, as SVG programs write them, both without; also translateX, translateY, scaleX, scaleY,
// skew, and "none". Nothing when any part is wrong, or is a percentage or a map of three
// dimensions.
std::optional<Transform> parse_transform_property(std::string_view text);

}  // namespace libstyle::svg
