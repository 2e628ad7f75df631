// SPDX-License-Identifier: Apache-2.0
// A text element taken apart: which characters are of which element, and with what style (SVG 1.1,
// chapter 10).
#pragma once

#include <algorithm>
#include <cstddef>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "converters/svg/canvas.h"
#include "converters/svg/file_index.h"
#include "converters/svg/reporter.h"

namespace libstyle::svg {

// One element of a text: text itself, tspan, tref or a. Lengths are in px.
struct TextPart {
  pugi::xml_node element;
  ComputedStyle style;
  // Where its first characters stand, and how far they are moved from there: one number for each
  // character, the first for the element as a whole if there is no other.
  std::vector<double> x, y, dx, dy;
  std::string borrowed;  // the characters that a tref refers to
  std::size_t end = 0;   // the parts after this one and before `end` are within it

  // How many characters have a place of their own.
  std::size_t placed() const { return std::max({x.size(), y.size(), dx.size(), dy.size()}); }
};

struct TextContent {
  std::vector<TextPart> parts;  // in the order of the file; the first one is the text element
  std::size_t characters = 0;   // bytes, in fact
  std::size_t longest = 0;      // of those between two tags
  std::size_t work = 0;         // the characters, and 16 for each node and place
};

// `scope` is that of the text element. What is not drawn ("display") is left out. Reading ends soon
// after `work_limit`. Warns about what is not carried.
TextContent read_text_content(pugi::xml_node element, const Scope& scope, const FileIndex& index,
                              std::size_t work_limit, Reporter& reporter);

// Whether a node is characters rather than an element.
bool is_characters(pugi::xml_node node);

}  // namespace libstyle::svg
