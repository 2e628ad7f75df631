// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/cascade.h"

#include <algorithm>
#include <vector>

#include "converters/svg/transform_list.h"

namespace libstyle::svg {
namespace {

// SVG 1.1, section 14.3.3: what opens a viewport within the drawing clips to it.
bool clips_by_default(pugi::xml_node element) {
  const std::string_view name = element.name();
  const bool outermost = element.parent().type() == pugi::node_document;
  return (name == "svg" && !outermost) || name == "symbol" || name == "marker" ||
         name == "pattern" || name == "image";
}

// What is a property and no attribute.
bool is_for_style_sheets_only(std::string_view name) {
  return name == "marker" || name == "mix-blend-mode" || name == "isolation";
}

void apply_attributes(pugi::xml_node element, ComputedStyle& style, const ComputedStyle& parent) {
  for (const pugi::xml_attribute attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (name == "transform") {
      style.transform = parse_transform_attribute(attribute.value());
    } else if (!is_for_style_sheets_only(name)) {
      const Property* const property = find_property(name);
      if (property != nullptr) apply(*property, attribute.value(), style, parent);
    }
  }
}

}  // namespace

ComputedStyle cascade(pugi::xml_node element, const ComputedStyle& parent,
                      const StyleSheets& sheets) {
  ComputedStyle style;
  static_cast<InheritedProperties&>(style) = parent;
  if (clips_by_default(element)) style.overflow = Overflow::kHidden;
  apply_attributes(element, style, parent);

  std::vector<Declaration> declarations;
  if (!sheets.empty()) sheets.find_matching(element, declarations);
  const pugi::xml_attribute attribute = element.attribute("style");
  if (attribute) {
    const std::vector<Declaration> own = parse_declarations(attribute.value());
    declarations.insert(declarations.end(), own.begin(), own.end());
  }
  for (const bool important : {false, true}) {
    for (const Declaration& declaration : declarations) {
      if (declaration.important != important) continue;
      apply(*declaration.property, declaration.value, style, parent);
    }
  }
  return style;
}

ComputedStyle style_in_place(pugi::xml_node element, const StyleSheets& sheets) {
  std::vector<pugi::xml_node> lineage;
  for (; element.type() == pugi::node_element; element = element.parent()) {
    lineage.push_back(element);
  }
  ComputedStyle style;
  std::ranges::for_each(lineage.rbegin(), lineage.rend(),
                        [&](pugi::xml_node node) { style = cascade(node, style, sheets); });
  return style;
}

}  // namespace libstyle::svg
