// SPDX-License-Identifier: Apache-2.0
// Text as paths: its characters laid out and drawn in the fonts of the system.
//
// librsvg does it. It gets a drawing of one text, made from what the cascade here has found,
// without the paint: each part is filled with a color of its own, so that the paths that come back
// say which part they are of. What it draws is large, because it rounds outlines to 1/64 px.
#pragma once

#include <cstddef>
#include <vector>

#include "converters/svg/text_content.h"
#include "libstyle/geometry/path.h"

namespace libstyle::svg {

// Characters of one part that stand together.
struct TextRun {
  std::size_t part = 0;
  Path path;  // in the user space of the text
};

// In the order in which they are painted, which is that of the parts. Throws Error when the text
// cannot be laid out.
std::vector<TextRun> outline_text(const TextContent& text);

}  // namespace libstyle::svg
