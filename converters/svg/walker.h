// SPDX-License-Identifier: Apache-2.0
// Goes through an SVG tree in the order it is painted: groups, switch, use, symbol, nested svg.
// Every shape it comes to is handed to a canvas with its style and its place.
#pragma once

#include <pugixml.hpp>
#include <span>
#include <vector>

#include "converters/svg/canvas.h"
#include "converters/svg/file_index.h"
#include "converters/svg/reporter.h"
#include "converters/svg/svg_reader.h"
#include "converters/svg/text_outlines.h"

namespace libstyle::svg {

// What all walks through one file share, and what they have used up.
struct Drawing {
  const XmlFile& file;
  const FileIndex& index;
  const SvgLimits& limits;
  Reporter& reporter;
  std::size_t used_elements = 0;
  std::size_t points = 0;
  std::size_t text_work = 0;
};

// Counts a node that is gone through again. Throws Error when that passes the limit.
void count_used(Drawing& drawing, pugi::xml_node node);

// Whether a walk is the one that draws the file, or goes through a part of it once more; what is
// gone through again counts against the limit of elements that are used.
enum class WalkKind : std::uint8_t { kFirst, kRepeated };

class Walker {
 public:
  Walker(Drawing& drawing, Canvas& canvas, WalkKind kind)
      : drawing_(drawing), canvas_(canvas), kind_(kind) {}

  // The element itself has been entered: `scope` is its own.
  void draw_children(pugi::xml_node element, const Scope& scope);

  // As above, where what a `use` refers to counts as its child.
  void draw_members(pugi::xml_node element, const Scope& scope);

 private:
  void draw(pugi::xml_node element, const Scope& parent);
  void draw_group(pugi::xml_node element, Scope& scope);
  void draw_switch(pugi::xml_node element, Scope& scope);
  void draw_nested_svg(pugi::xml_node element, Scope& scope);
  void draw_use(pugi::xml_node element, Scope& scope);
  std::optional<Rectangle> read_use_viewport(pugi::xml_node use, const Scope& scope);
  void draw_target(pugi::xml_node target, pugi::xml_node use, const Scope& scope,
                   const Rectangle& viewport);
  void draw_symbol(pugi::xml_node symbol, pugi::xml_node use, const Scope& scope,
                   const Rectangle& viewport);
  void draw_viewport(pugi::xml_node element, Scope& scope, const Rectangle& viewport,
                     const View& view);
  void draw_shape(pugi::xml_node element, ElementKind kind, const Scope& scope);
  void draw_text(pugi::xml_node element, Scope& scope);
  void draw_text_part(const TextContent& text, std::size_t part, std::span<TextRun> runs,
                      Scope& scope);
  void draw_outline(pugi::xml_node element, ElementKind kind, Path path, const Scope& scope);

  Scope enter(pugi::xml_node element, const Scope& parent) const;
  void check_depth(pugi::xml_node element, const Scope& scope) const;
  void count_node(pugi::xml_node node);
  void count_points(pugi::xml_node element, const Path& path);

  Drawing& drawing_;
  Canvas& canvas_;
  WalkKind kind_;
  std::vector<pugi::xml_node> uses_;  // the use elements that are being drawn
};

}  // namespace libstyle::svg
