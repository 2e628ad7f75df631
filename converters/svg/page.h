// SPDX-License-Identifier: Apache-2.0
// The size of the page that the outermost svg element asks for, and how its contents are laid on
// it.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>

#include "converters/svg/computed_style.h"
#include "libstyle/geometry/transform.h"

namespace libstyle::svg {

struct Page {
  // px; unset: as large as what is drawn.
  std::optional<double> width, height;
  // In the original unit, "210mm"; empty: px.
  std::string width_text, height_text;
  // Unset: nothing is drawn.
  std::optional<Transform> page_from_user;
  Vector viewport;  // what percentages within refer to
};

// A size that is missing or in percent is that of the viewBox.
Page read_page(pugi::xml_node root, const ComputedStyle& style);

}  // namespace libstyle::svg
