// SPDX-License-Identifier: Apache-2.0
// How a page becomes a picture of a certain size.
#pragma once

#include <optional>

#include "libstyle/curves/document.h"

namespace libstyle {

// What is asked for. The page keeps its proportions: with one of width and height the other
// follows, with both it becomes as large as fits in them. `scale` is used without either.
struct PictureSize {
  std::optional<double> width, height;  // px
  double scale = 1;
};

struct Viewport {
  double width = 0, height = 0;  // of the picture, px, not rounded; 0 when there is nothing to draw
  Transform picture_from_page;
};

// A page without width or height is as large as what is drawn on it. Throws Error when the picture
// would have no size that can be drawn.
Viewport make_viewport(const Document& document, const PictureSize& size);

}  // namespace libstyle
