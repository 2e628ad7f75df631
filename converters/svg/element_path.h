// SPDX-License-Identifier: Apache-2.0
// The geometry of a basic shape or path element.
#pragma once

#include <pugixml.hpp>

#include "converters/svg/computed_style.h"
#include "converters/svg/element_kind.h"
#include "converters/svg/reporter.h"
#include "libstyle/geometry/path.h"

namespace libstyle::svg {

// What lengths in an element of this style refer to within a viewport of this size.
LengthContext length_context(const ComputedStyle& style, const Vector& viewport);

// In the element's own user space. A path with an error is drawn up to there, with a warning; one
// of more than `point_limit` points may end after that.
Path element_path(pugi::xml_node element, ElementKind kind, const ComputedStyle& style,
                  const Vector& viewport, std::size_t point_limit, Reporter& reporter);

}  // namespace libstyle::svg
