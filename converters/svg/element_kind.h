// SPDX-License-Identifier: Apache-2.0
// What an element of an SVG file means to us, by its canonical name (xml.h).
#pragma once

#include <cstdint>
#include <string_view>

namespace libstyle::svg {

enum class ElementKind : std::uint8_t {
  kGroup,  // g, a
  kSwitch,
  kSvg,
  kUse,
  kRect,
  kCircle,
  kEllipse,
  kLine,
  kPolyline,
  kPolygon,
  kPath,
  kText,
  kNeverDrawn,  // drawn only where something refers to it, or never: defs, symbol, title ...
  kActive,      // moves or runs: animations and scripts
  kNotCarried,  // draws something that is not lines: image, what we do not know
  kForeign      // of another namespace
};

ElementKind element_kind(std::string_view name);

constexpr bool is_shape(ElementKind kind) {
  return kind >= ElementKind::kRect && kind <= ElementKind::kPath;
}

}  // namespace libstyle::svg
