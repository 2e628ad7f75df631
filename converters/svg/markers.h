// SPDX-License-Identifier: Apache-2.0
// Markers drawn at the vertices of a path, each as a group of its own after the path.
#pragma once

#include <pugixml.hpp>
#include <vector>

#include "converters/svg/canvas.h"
#include "converters/svg/marker_vertices.h"
#include "converters/svg/walker.h"

namespace libstyle::svg {

class Markers {
 public:
  // What is in a marker is drawn on `canvas`.
  Markers(Drawing& drawing, Canvas& canvas) : drawing_(drawing), canvas_(canvas) {}

  // Whether an element asks for any that are there.
  bool any(ElementKind kind, const ComputedStyle& style) const;

  // Draws those that the style of an element asks for on its path, in user space. Opacity and clip
  // of the element are left to the group that `scope` is in.
  void draw(pugi::xml_node element, ElementKind kind, const Path& path, const Scope& scope);

 private:
  pugi::xml_node marker_for(MarkerPlace place, const ComputedStyle& style) const;
  void draw_one(pugi::xml_node marker, const MarkerVertex& vertex, const Scope& scope);

  Drawing& drawing_;
  Canvas& canvas_;
  std::vector<pugi::xml_node> open_;  // markers that are being drawn
};

}  // namespace libstyle::svg
