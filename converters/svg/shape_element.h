// SPDX-License-Identifier: Apache-2.0
// Paths as the basic shapes they were drawn as, so that people find a circle where they left one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libstyle/geometry/path.h"

namespace libstyle::svg {

// An element and the attributes of its geometry.
struct ShapeElement {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string>> attributes;
};

// The element `shape` ("rect", "circle", ...) that reads as exactly this path, to the last bit.
// Nothing when there is none: the path was turned or bent since.
std::optional<ShapeElement> shape_element(std::string_view shape, const Path& path);

// Moves the points of a path that is this shape but for rounding, as after a transform, by as
// little as it takes for shape_element to find it: at most 1e-12 of its coordinates.
void settle_shape(std::string_view shape, Path& path);

}  // namespace libstyle::svg
