// SPDX-License-Identifier: Apache-2.0
// Goes through an SVG tree in the order it is painted and adds what it draws to a document.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "converters/svg/computed_style.h"
#include "converters/svg/document_builder.h"
#include "converters/svg/element_kind.h"
#include "converters/svg/file_index.h"
#include "converters/svg/painter.h"
#include "converters/svg/reporter.h"
#include "converters/svg/svg_reader.h"
#include "converters/svg/view_box.h"

namespace libstyle::svg {

class Walker {
 public:
  Walker(const XmlFile& file, const FileIndex& index, const SvgLimits& limits, Reporter& reporter,
         Document& document);

  // Draws the whole file and sets the size of the page.
  void walk();

 private:
  // Where an element is drawn.
  struct Scope {
    ComputedStyle style;  // of the element itself, once entered
    Transform page_from_user;
    Vector viewport;    // size of the nearest viewport, in its own units
    std::string group;  // id of the record that members are in
    std::size_t depth = 0;
  };

  void draw(pugi::xml_node element, const Scope& parent);
  void draw_children(pugi::xml_node element, const Scope& scope);
  void draw_group(pugi::xml_node element, Scope& scope);
  void draw_switch(pugi::xml_node element, Scope& scope);
  void draw_nested_svg(pugi::xml_node element, Scope& scope);
  void draw_use(pugi::xml_node element, Scope& scope);
  void draw_target(pugi::xml_node target, pugi::xml_node use, Scope& scope);
  void draw_viewport(pugi::xml_node element, Scope& scope, const Rectangle& viewport);
  void draw_shape(pugi::xml_node element, ElementKind kind, const Scope& scope);

  Scope enter(pugi::xml_node element, const Scope& parent) const;
  void open_root(pugi::xml_node root, Scope& scope);
  void open_group(pugi::xml_node element, Scope& scope, const std::string& clip = "");
  std::string add_viewport_clip(const Rectangle& viewport, const Scope& scope);
  Rectangle viewport_of(const ComputedStyle& style, const Scope& scope) const;
  bool is_cycle(pugi::xml_node use, pugi::xml_node target) const;
  void count_element(pugi::xml_node element, const Scope& scope);
  void count_points(pugi::xml_node element, const Path& path);
  void warn_not_carried(pugi::xml_node element, const ComputedStyle& style);
  void warn_markers(pugi::xml_node element, ElementKind kind, const ComputedStyle& style);

  const XmlFile& file_;
  const FileIndex& index_;
  const SvgLimits& limits_;
  Reporter& reporter_;
  Document& document_;
  DocumentBuilder builder_;
  Painter painter_;
  std::vector<pugi::xml_node> targets_;  // of the use elements that are being drawn
  std::size_t used_elements_ = 0;
  std::size_t points_ = 0;
};

}  // namespace libstyle::svg
