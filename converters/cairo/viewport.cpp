// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/viewport.h"

#include <algorithm>
#include <cmath>

#include "converters/cairo/ink.h"
#include "libstyle/base/error.h"

namespace libstyle {
namespace {

Box page_of(const Document& document) {
  const Header& header = document.header;
  Box page = {{0, 0}, {header.width.value_or(0), header.height.value_or(0)}};
  if (header.width && header.height) return page;
  const Box drawn = drawn_box(document);
  if (drawn.empty()) return page;
  if (!header.width) {
    page.low.x = drawn.low.x;
    page.high.x = drawn.high.x;
  }
  if (!header.height) {
    page.low.y = drawn.low.y;
    page.high.y = drawn.high.y;
  }
  return page;
}

double scale_for(const Box& page, const PictureSize& size) {
  const double for_width = size.width ? *size.width / page.width() : 0;
  const double for_height = size.height ? *size.height / page.height() : 0;
  if (size.width && size.height) return std::min(for_width, for_height);
  if (size.width) return for_width;
  return size.height ? for_height : size.scale;
}

}  // namespace

Viewport make_viewport(const Document& document, const PictureSize& size) {
  const Box page = page_of(document);
  if (!(page.width() > 0 && page.height() > 0)) return {};
  const double scale = scale_for(page, size);
  Viewport viewport{scale * page.width(), scale * page.height(), Transform::scaling(scale, scale)};
  viewport.picture_from_page.e = -scale * page.low.x;
  viewport.picture_from_page.f = -scale * page.low.y;
  if (!viewport.picture_from_page.is_finite() || !std::isfinite(viewport.width) ||
      !std::isfinite(viewport.height) || !(scale > 0)) {
    throw Error("the page is too large or too small to be drawn; check its width and height");
  }
  return viewport;
}

}  // namespace libstyle
