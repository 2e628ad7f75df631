// SPDX-License-Identifier: Apache-2.0
// The property paint-order: in which order fill, stroke and markers of a shape are painted.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace libstyle::svg {

enum class PaintPart : std::uint8_t { kFill, kStroke, kMarkers };

struct PaintOrder {
  std::array<PaintPart, 3> parts = {PaintPart::kFill, PaintPart::kStroke, PaintPart::kMarkers};

  bool comes_before(PaintPart a, PaintPart b) const {
    for (const PaintPart part : parts) {
      if (part == a || part == b) return part == a;
    }
    return false;
  }
};

// "normal", or the parts that come first, in any case; what is left out follows in the usual order.
// Nothing when a part is there twice.
std::optional<PaintOrder> parse_paint_order(std::string_view text);

}  // namespace libstyle::svg
