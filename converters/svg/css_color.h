// SPDX-License-Identifier: Apache-2.0
// Colours as CSS Color level 3 and 4 write them.
#pragma once

#include <optional>
#include <string_view>

#include "libstyle/curves/style.h"

namespace libstyle::svg {

struct CssColor {
  Color color;       // its own alpha stays 255
  double alpha = 1;  // 0 .. 1

  friend bool operator==(const CssColor&, const CssColor&) = default;
};

// "#rgb", "#rrggbb" and both with alpha, rgb() and rgba() in numbers or percent, hsl() and hsla(),
// with commas or with spaces and a slash, the 148 names (with rebeccapurple) in any case,
// "transparent". Values out of range are put into it. Nothing for anything else, "currentColor" and
// "none" too, which are not colours of their own.
std::optional<CssColor> parse_css_color(std::string_view text);

}  // namespace libstyle::svg
