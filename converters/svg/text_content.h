// SPDX-License-Identifier: Apache-2.0
// A text element taken apart: which characters are of which element, and with what style (SVG 1.1,
// chapter 10).
#pragma once

#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "converters/svg/canvas.h"
#include "converters/svg/file_index.h"
#include "converters/svg/reporter.h"

namespace libstyle::svg {

// One element of a text: text itself, tspan, tref or a.
struct TextPart {
  pugi::xml_node element;
  ComputedStyle style;
  std::optional<double> x, y;  // where it begins; px, as all lengths here
  double dx = 0, dy = 0;
  std::string borrowed;  // the characters that a tref refers to
  std::size_t end = 0;   // the parts after this one and before `end` are within it
};

struct TextContent {
  std::vector<TextPart> parts;  // in the order of the file; the first one is the text element
  std::size_t characters = 0;   // bytes, in fact
  std::size_t longest = 0;      // of those between two tags
  std::size_t work = 0;         // the characters, and 16 for each node of the file
};

// `scope` is that of the text element. What is not drawn ("display") is left out. Reading ends soon
// after `work_limit`. Warns about what is not carried.
TextContent read_text_content(pugi::xml_node element, const Scope& scope, const FileIndex& index,
                              std::size_t work_limit, Reporter& reporter);

// Whether a node is characters rather than an element.
bool is_characters(pugi::xml_node node);

}  // namespace libstyle::svg
