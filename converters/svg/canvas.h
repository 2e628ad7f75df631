// SPDX-License-Identifier: Apache-2.0
// What a walk through a drawing (walker.h) hands its findings to. One canvas makes records of them,
// one gathers the inside of a clipPath, one measures a box.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>

#include "converters/svg/computed_style.h"
#include "converters/svg/element_kind.h"
#include "converters/svg/paint_context.h"
#include "converters/svg/view_box.h"
#include "libstyle/geometry/path.h"

namespace libstyle::svg {

// Where an element is drawn.
struct Scope {
  ComputedStyle style;  // of the element itself
  PaintContext paint_context;
  Transform page_from_user;
  Vector viewport;        // size of the nearest viewport, in its own units
  std::string group;      // id of the record that members are in
  std::string path_clip;  // id of a clip that the one path within takes over
  std::size_t depth = 0;
  std::optional<Box> bounds;  // of the text that this is a part of: what "objectBoundingBox" means
};

class Canvas {
 public:
  virtual ~Canvas() = default;

  // Comes before the members of a group, which are drawn in `scope` as this leaves it. `viewport`
  // is what the group clips to, if it does, in user space. Returns whether to draw the members.
  virtual bool open_group(pugi::xml_node element, Scope& scope,
                          const std::optional<Rectangle>& viewport) = 0;

  // `path` is in user space, and brought to the page it is finite.
  virtual void draw_path(pugi::xml_node element, ElementKind kind, Path path,
                         const Scope& scope) = 0;
};

}  // namespace libstyle::svg
