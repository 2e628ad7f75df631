// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/paint_order.h"

#include <algorithm>

#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

std::optional<PaintPart> find_part(std::string_view word) {
  if (equal_ignoring_case(word, "fill")) return PaintPart::kFill;
  if (equal_ignoring_case(word, "stroke")) return PaintPart::kStroke;
  if (equal_ignoring_case(word, "markers")) return PaintPart::kMarkers;
  return std::nullopt;
}

}  // namespace

std::optional<PaintOrder> parse_paint_order(std::string_view text) {
  PaintOrder order;
  if (equal_ignoring_case(trimmed(text), "normal")) return order;
  auto* next = order.parts.begin();
  Scanner scanner(text);
  for (scanner.skip_spaces(); !scanner.at_end(); scanner.skip_spaces()) {
    const std::optional<PaintPart> part = find_part(scanner.take_word());
    if (!part) return std::nullopt;
    auto* const place = std::find(next, order.parts.end(), *part);
    if (place == order.parts.end()) return std::nullopt;
    std::rotate(next, place, place + 1);
    ++next;
  }
  if (next == order.parts.begin()) return std::nullopt;
  return order;
}

}  // namespace libstyle::svg
