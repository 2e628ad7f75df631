// SPDX-License-Identifier: Apache-2.0
// The style of an element from everything that has a say in it, the last one winning: inheritance,
// presentation attributes, style sheets by specificity, the style attribute, then what is marked
// !important in sheets and attribute.
#pragma once

#include <pugixml.hpp>

#include "converters/svg/computed_style.h"
#include "converters/svg/style_sheet.h"

namespace libstyle::svg {

// The style of `element` below a parent of style `parent`. `use` draws an element below another
// parent than the one it has in the file; selectors look at the file.
ComputedStyle cascade(pugi::xml_node element, const ComputedStyle& parent,
                      const StyleSheets& sheets);

// The style of an element where it stands in the file.
ComputedStyle style_in_place(pugi::xml_node element, const StyleSheets& sheets);

}  // namespace libstyle::svg
