// SPDX-License-Identifier: Apache-2.0
// Documents made and drawn in a line or two.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libstyle/base/warning.h"
#include "libstyle/curves/document.h"
#include "tests/support/image.h"

namespace libstyle {

constexpr Color kBlack = {0, 0, 0};
constexpr Color kRed = {255, 0, 0};
constexpr Color kBlue = {0, 0, 255};

// A page of 100 x 100 px.
Document make_page(Records records = {});

PathRecord filled(std::string_view data, Color color = kBlack);
PathRecord stroked(std::string_view data, double width, Color color = kBlack);
GroupRecord group(std::string id, double opacity = 1, std::string clip = "");
ClipRecord clip(std::string id, std::vector<ClipPart> parts);
ClipPart part(std::string_view data, FillRule rule = FillRule::kNonZero);

template <typename RecordType>
RecordType in(std::string parent, RecordType record) {
  record.parent = std::move(parent);
  return record;
}

// The document as PNG bytes, and as it looks.
std::string draw_png(const Document& document, const WarningHandler& warn = {});
Raster draw(const Document& document, const WarningHandler& warn = {});

// How many pixels differ by more than `bound` in any channel.
std::size_t count_different(const Raster& a, const Raster& b, int bound);

// The alpha of all pixels together, in pixels.
double covered_area(const Raster& image);

}  // namespace libstyle
