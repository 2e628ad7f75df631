// SPDX-License-Identifier: Apache-2.0
// Measures what is drawn, strokes not counted: what "objectBoundingBox" means for a group.
#pragma once

#include "converters/svg/canvas.h"
#include "converters/svg/walker.h"
#include "libstyle/geometry/box.h"

namespace libstyle::svg {

class BoundsCanvas final : public Canvas {
 public:
  explicit BoundsCanvas(const Transform& group_from_page) : group_from_page_(group_from_page) {}

  bool open_group(pugi::xml_node element, Scope& scope,
                  const std::optional<Rectangle>& viewport) override;
  void draw_path(pugi::xml_node element, ElementKind kind, Path path, const Scope& scope) override;

  const Box& bounds() const { return bounds_; }

 private:
  Transform group_from_page_;
  Box bounds_;
};

// The box of the members of a group, in its own user space.
Box measure_members(Drawing& drawing, pugi::xml_node group, const Scope& scope);

}  // namespace libstyle::svg
