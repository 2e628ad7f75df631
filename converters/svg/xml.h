// SPDX-License-Identifier: Apache-2.0
// An SVG file as a tree of XML elements, as found in the wild.
//
// The stages: what gzip has packed is unpacked (gzip.h), bytes to UTF-8 (encoding.h), entities
// expanded (entities.h), pugixml's parser, then names made canonical, so that nobody after this
// thinks of namespaces:
// - SVG elements have their plain name ("svg:rect" is "rect"). A file that declares no namespace is
//   SVG too. Elements of other namespaces have a ':' in their name.
// - Attributes of the namespaces we know have their usual prefix whatever the file calls it:
//   "xlink:href", "inkscape:label", "sodipodi:type", "xml:space", "curves:keys".
#pragma once

#include <cstddef>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "converters/svg/entities.h"
#include "libstyle/base/warning.h"

namespace libstyle::svg {

struct XmlLimits {
  std::size_t bytes = std::size_t{256} << 20;  // packed, and unpacked
  std::size_t depth = 1000;                    // elements within elements
  EntityLimits entities;
};

class XmlFile {
 public:
  // `file` is how messages call the text. Throws Error with file and line when the text is not
  // well-formed, is cut off, passes a limit, or its outermost element is not svg.
  XmlFile(std::string text, std::string file, const XmlLimits& limits, const WarningHandler& warn);
  XmlFile(const XmlFile&) = delete;
  XmlFile& operator=(const XmlFile&) = delete;

  // The outermost svg element.
  pugi::xml_node root() const { return tree_.document_element(); }
  const pugi::xml_document& document() const { return tree_; }

  // Where an element of the tree was read.
  Place place(pugi::xml_node node) const;
  const std::string& name() const { return file_; }

 private:
  Place place_of_offset(std::ptrdiff_t offset) const;

  std::string text_;  // the tree points into it
  std::string file_;
  std::vector<std::size_t> line_ends_;
  pugi::xml_document tree_;
};

// Whether an element or attribute is of a namespace that is neither SVG's nor none.
bool is_foreign(std::string_view name);

}  // namespace libstyle::svg
