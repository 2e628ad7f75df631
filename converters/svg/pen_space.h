// SPDX-License-Identifier: Apache-2.0
// From the page to the space of a pen and back, to the last bit.
//
// A pen that is no circle is a transform of its element, whose path and gradients then stand in the
// space of the pen. Going there and back rounds. So what is written there has its numbers on the
// page beside it, in an attribute of ours. They count as long as going there from them gives the
// very numbers that stand in the element: when somebody has edited those, or a transform around
// them, the edit has the say.
#pragma once

#include <optional>
#include <string_view>

#include "libstyle/geometry/path.h"
#include "libstyle/geometry/transform.h"

namespace libstyle::svg {

// Nothing when the space has no inverse or the result is beyond all numbers.
std::optional<Path> to_pen_space(const Path& page_path, const Transform& page_from_pen);
std::optional<Transform> to_pen_space(const Transform& page_from_gradient,
                                      const Transform& page_from_pen);

// `carried` is path data or a transform on the page as text; empty, or wrong in any way: none.
Path to_page(Path pen_path, const Transform& page_from_pen, std::string_view carried);
Transform to_page(const Transform& pen_from_gradient, const Transform& page_from_pen,
                  std::string_view carried);

}  // namespace libstyle::svg
