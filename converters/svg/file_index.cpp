// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/file_index.h"

#include <string>

#include "converters/svg/css_text.h"
#include "converters/svg/element_kind.h"
#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

// The node after `node` in the order of the file.
pugi::xml_node next_in_file(pugi::xml_node node) {
  if (node.first_child()) return node.first_child();
  while (node && !node.next_sibling()) node = node.parent();
  return node.next_sibling();
}

// Comments of CSS in attributes: all that are values of CSS, so not names, data and path data.
bool may_hold_css_comments(pugi::xml_attribute attribute) {
  const std::string_view name = attribute.name();
  return std::string_view(attribute.value()).find("/*") != std::string_view::npos && name != "d" &&
         name != "id" && name != "class" && !name.ends_with("href") && !name.starts_with("data-") &&
         name.find(':') == name.npos;
}

}  // namespace

FileIndex::FileIndex(const XmlFile& file, const std::string& last_sheet, std::size_t match_steps,
                     Reporter& reporter, const WarningHandler& warn)
    : sheets_(match_steps) {
  for (pugi::xml_node node = file.document().first_child(); node; node = next_in_file(node)) {
    if (node.type() == pugi::node_element) {
      visit(node, file, reporter, warn);
    } else if (node.type() == pugi::node_pi && std::string_view(node.name()) == "xml-stylesheet") {
      warn({file.place(node), "", "a style sheet in another file is not opened"});
    }
  }
  sheets_.add(last_sheet, {"style sheet", 0}, warn);
}

void FileIndex::visit(pugi::xml_node element, const XmlFile& file, Reporter& reporter,
                      const WarningHandler& warn) {
  const std::string_view id = element.attribute("id").value();
  if (!id.empty()) elements_.try_emplace(id, element);
  for (pugi::xml_attribute attribute : element.attributes()) {
    if (!may_hold_css_comments(attribute)) continue;
    attribute.set_value(without_comments(attribute.value()).c_str());
  }
  const std::string_view name = element.name();
  if (name == "style") {
    add_sheet(element, file, warn);
  } else if (element_kind(name) == ElementKind::kActive) {
    reporter.warn(element, std::string(name) + " is not carried");
  }
}

void FileIndex::add_sheet(pugi::xml_node element, const XmlFile& file, const WarningHandler& warn) {
  std::string text;
  for (const pugi::xml_node child : element.children()) text += child.value();
  sheets_.add(text, file.place(element), warn);
}

pugi::xml_node FileIndex::find(std::string_view id) const {
  const auto found = elements_.find(id);
  return found == elements_.end() ? pugi::xml_node() : found->second;
}

pugi::xml_node FileIndex::find_reference(std::string_view reference) const {
  return reference.starts_with('#') ? find(reference.substr(1)) : pugi::xml_node();
}

pugi::xml_node FileIndex::find_target(pugi::xml_node element) const {
  return find_reference(link_of(element));
}

std::string_view link_of(pugi::xml_node element) {
  pugi::xml_attribute link = element.attribute("href");
  if (!link) link = element.attribute("xlink:href");
  return link.value();
}

}  // namespace libstyle::svg
