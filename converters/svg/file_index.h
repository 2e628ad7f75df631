// SPDX-License-Identifier: Apache-2.0
// What must be known of a file before anything is drawn: ids and style sheets, wherever they stand.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>

#include "converters/svg/reporter.h"
#include "converters/svg/style_sheet.h"
#include "converters/svg/xml.h"

namespace libstyle::svg {

class FileIndex {
 public:
  // `last_sheet` is CSS that comes after that of the file. Takes comments out of style attributes.
  // Warns about scripts, animations and style sheets of other files.
  FileIndex(const XmlFile& file, const std::string& last_sheet, std::size_t match_steps,
            Reporter& reporter, const WarningHandler& warn);

  // The first element of this id; null when there is none.
  pugi::xml_node find(std::string_view id) const;
  // The element that "#id" names; null for other files and for what is not there.
  pugi::xml_node find_reference(std::string_view reference) const;
  // The element that href, or xlink:href, names.
  pugi::xml_node find_target(pugi::xml_node element) const;

  const StyleSheets& sheets() const { return sheets_; }

 private:
  void visit(pugi::xml_node element, const XmlFile& file, Reporter& reporter,
             const WarningHandler& warn);
  void add_sheet(pugi::xml_node element, const XmlFile& file, const WarningHandler& warn);

  std::unordered_map<std::string_view, pugi::xml_node>
      elements_;  // looked up, never walked through
  StyleSheets sheets_;
};

// The value of href, or of the older xlink:href.
std::string_view link_of(pugi::xml_node element);

}  // namespace libstyle::svg
