// SPDX-License-Identifier: Apache-2.0
// How a path is painted. Names, meanings and initial values are those of SVG 1.1, chapter 11,
// except that nothing is filled unless it says so (see Style).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "libstyle/geometry/transform.h"

namespace libstyle {

// sRGB, 8 bits a channel. Alpha is used where a colour varies along a curve; elsewhere opacity has
// its own key and alpha stays 255.
struct Color {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;

  friend bool operator==(const Color&, const Color&) = default;
};

// "#rrggbb", or "#rrggbbaa" where alpha is not 255.
std::string to_text(Color color);
std::optional<Color> parse_color(std::string_view text);

// Colours made from colours channel by channel, such as by interpolation: `map` makes the new
// values of a channel of the old ones, in 0 .. 255.
std::vector<Color> map_channels(
    std::span<const Color> colors,
    const std::function<std::vector<double>(std::span<const double>)>& map);

struct NoPaint {
  friend bool operator==(const NoPaint&, const NoPaint&) = default;
};

// Paint by reference to a gradient record, "url(#id)" in the format.
struct PaintReference {
  std::string id;

  friend bool operator==(const PaintReference&, const PaintReference&) = default;
};

using Paint = std::variant<NoPaint, Color, PaintReference>;

enum class FillRule : std::uint8_t { kNonZero, kEvenOdd };
enum class LineCap : std::uint8_t { kButt, kRound, kSquare };
enum class LineJoin : std::uint8_t { kMiter, kRound, kBevel };

// How a picture is mixed with what lies below it, named as in CSS (Compositing and Blending level
// 1).
enum class BlendMode : std::uint8_t {
  kNormal,
  kMultiply,
  kScreen,
  kOverlay,
  kDarken,
  kLighten,
  kColorDodge,
  kColorBurn,
  kHardLight,
  kSoftLight,
  kDifference,
  kExclusion,
  kHue,
  kSaturation,
  kColor,
  kLuminosity
};

inline constexpr std::array<std::string_view, 16> kBlendModeNames = {
    "normal",      "multiply",   "screen",     "overlay",    "darken",     "lighten",
    "color-dodge", "color-burn", "hard-light", "soft-light", "difference", "exclusion",
    "hue",         "saturation", "color",      "luminosity"};

// A path whose fill and stroke are both unset is a bare curve: it is drawn as a black line 1 px
// wide. Otherwise what is unset is not painted.
struct Style {
  std::optional<Paint> fill;
  double fill_opacity = 1;  // 0 .. 1
  FillRule fill_rule = FillRule::kNonZero;

  std::optional<Paint> stroke;
  double stroke_opacity = 1;  // 0 .. 1
  double stroke_width = 1;    // px, >= 0
  LineCap line_cap = LineCap::kButt;
  LineJoin line_join = LineJoin::kMiter;
  double miter_limit = 4;          // >= 1
  std::vector<double> dash_array;  // px, alternating dash and gap; empty: solid
  double dash_offset = 0;          // px
  // page_from_pen: the pen is a circle in its own space. Set only when that is not a uniform scale;
  // width and dashes are then lengths in the space of the pen.
  std::optional<Transform> stroke_transform;

  bool stroke_first = false;  // paint-order: stroke
  bool crisp_edges = false;   // shape-rendering: crispEdges; pixels are painted whole or not at all
  double opacity = 1;         // 0 .. 1, of fill and stroke together
  bool hidden = false;        // visibility: hidden; kept, not drawn

  friend bool operator==(const Style&, const Style&) = default;

  bool is_bare() const { return !fill && !stroke; }
};

}  // namespace libstyle
