// SPDX-License-Identifier: Apache-2.0
// What the element of a gradient says, with what it takes over from others by href.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string_view>
#include <vector>

#include "converters/svg/file_index.h"
#include "converters/svg/length.h"
#include "converters/svg/reporter.h"
#include "libstyle/curves/document.h"

namespace libstyle::svg {

struct GradientDefinition {
  bool radial = false;
  bool in_bounding_box = true;  // gradientUnits
  Transform transform;
  std::string_view carried_transform;  // of the element itself; see pen_space.h
  Spread spread = Spread::kPad;
  // Of a linear gradient: start and end. Of a radial one: center and focus, and the two radii.
  Length x1, y1, x2, y2;
  Length center_x, center_y, focus_x, focus_y, radius, focus_radius;
  std::vector<GradientStop> stops;
};

// Whether an element is a gradient.
bool is_gradient(pugi::xml_node element);

// Follows href from gradient to gradient. Nothing when the chain leads nowhere, to something else
// or in a circle, or a transform has no inverse: there is then nothing to paint with.
std::optional<GradientDefinition> read_gradient(pugi::xml_node element, const FileIndex& index,
                                                Reporter& reporter);

}  // namespace libstyle::svg
