// SPDX-License-Identifier: Apache-2.0
// The table of properties: what CSS and presentation attributes can set.
#pragma once

#include <string_view>

#include "converters/svg/computed_style.h"

namespace libstyle::svg {

struct Property {
  std::string_view name;
  // Sets the property from its text; says no, leaving the style alone, when the value is wrong.
  // Relative values refer to the style of the parent.
  bool (*set)(ComputedStyle& style, const ComputedStyle& parent, std::string_view value);
  void (*copy)(ComputedStyle& to, const ComputedStyle& from);
};

// The property of this name in lower case, or null. `marker`, a shorthand, is one.
const Property* find_property(std::string_view name);

// As Property::set, and knows "inherit" and "initial".
bool apply(const Property& property, std::string_view value, ComputedStyle& style,
           const ComputedStyle& parent);

// What stands in "url(#name)", without the quotes that may be there, or "" when `text` does not
// begin with url(). The text after it is left in `rest`.
std::string_view take_url(std::string_view text, std::string_view& rest);

}  // namespace libstyle::svg
