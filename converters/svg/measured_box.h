// SPDX-License-Identifier: Apache-2.0
// The box of a shape, as librsvg measures it: what "objectBoundingBox" means.
#pragma once

#include <optional>

#include "libstyle/geometry/box.h"
#include "libstyle/geometry/path.h"
#include "libstyle/geometry/transform.h"

namespace libstyle::svg {

// The box around what `map` makes of a box.
Box mapped_box(const Box& box, const Transform& map);

// The box of the lines and curves of a path in user space; moves to nowhere do not count. Of one
// that is turned or skewed it is the box around that on the page, brought back, and so too large.
// Nothing where the page has no way back.
std::optional<Box> measured_box(const Path& path, const Transform& page_from_user);

}  // namespace libstyle::svg
