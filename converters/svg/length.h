// SPDX-License-Identifier: Apache-2.0
// Lengths with units, at 96 px to the inch.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace libstyle::svg {

enum class LengthUnit : std::uint8_t { kPx, kPt, kPc, kMm, kCm, kIn, kEm, kEx, kPercent };

struct Length {
  double value = 0;
  LengthUnit unit = LengthUnit::kPx;  // also that of a plain number

  friend bool operator==(const Length&, const Length&) = default;
};

// What the part of a viewport that percentages refer to is (SVG 1.1, section 7.10).
enum class LengthAxis : std::uint8_t {
  kHorizontal,  // its width
  kVertical,    // its height
  kDiagonal     // sqrt((width^2 + height^2) / 2)
};

struct LengthContext {
  double viewport_width = 0;  // px, of the nearest viewport in its own units
  double viewport_height = 0;
  double font_size = 16;  // px
};

// The unit of a name, "" being px; letters in any case. Nothing for an unknown one. (The sign of a
// percentage is not a name.)
std::optional<LengthUnit> length_unit(std::string_view name);

// "10", "2.5cm", " 50% ". Nothing when the text is anything else.
std::optional<Length> parse_length(std::string_view text);

// As above, of which only the beginning needs to be a length: "10 px", "10,5" are 10. So librsvg
// reads attributes that are no properties.
std::optional<Length> parse_leading_length(std::string_view text);

// Lengths separated by white space and commas, as in stroke-dasharray. Nothing when one is wrong.
std::optional<std::vector<Length>> parse_length_list(std::string_view text);

// In px. An ex is half an em.
double resolve(Length length, LengthAxis axis, const LengthContext& context);

// A plain number, nothing else around it.
std::optional<double> parse_number(std::string_view text);

// A number or a percentage as a share, put into 0 .. 1.
std::optional<double> parse_opacity(std::string_view text);
std::optional<double> parse_leading_opacity(std::string_view text);

}  // namespace libstyle::svg
