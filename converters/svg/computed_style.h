// SPDX-License-Identifier: Apache-2.0
// The properties of an element after cascade and inheritance, as far as anything here reads them.
// Lengths keep their unit: they are resolved where they are used, against the viewport there.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "converters/svg/css_color.h"
#include "converters/svg/length.h"
#include "converters/svg/paint_order.h"
#include "libstyle/curves/style.h"
#include "libstyle/geometry/transform.h"

namespace libstyle::svg {

// A colour that may be that of the property `color`, or no paint at all.
struct SolidPaint {
  enum class Kind : std::uint8_t { kNone, kColor, kCurrentColor, kContextFill, kContextStroke };

  Kind kind = Kind::kNone;
  CssColor color;

  static SolidPaint of(CssColor color) { return {Kind::kColor, color}; }
  // The colour meant, or nothing for no paint. (What a context means is left to paint_context.h.)
  std::optional<CssColor> resolve(const CssColor& current_color) const {
    if (kind == Kind::kColor) return color;
    if (kind == Kind::kCurrentColor) return current_color;
    return std::nullopt;
  }
};

// Fill or stroke: by reference with a paint to fall back to, or plain.
struct SpecifiedPaint {
  std::string_view reference;  // what url() holds; empty: none
  SolidPaint solid;            // alone, or where the reference leads nowhere
};

enum class Display : std::uint8_t { kInline, kNone };
enum class Visibility : std::uint8_t { kVisible, kHidden };
enum class Overflow : std::uint8_t { kVisible, kHidden };

// What says how text is laid out, besides its size. Words that are empty are initial.
struct InheritedTextProperties {
  std::string_view font_family;
  std::string_view font_style;
  std::string_view font_variant;
  std::string_view font_stretch;
  int font_weight = 400;
  Length letter_spacing;
  std::string_view text_anchor;
  std::string_view direction;
  std::string_view writing_mode;
  std::string_view text_orientation;
  std::string_view language;     // xml:lang
  std::string_view white_space;  // xml:space
};

// The views point into the text of the file or of its style sheets.
struct InheritedProperties : InheritedTextProperties {
  CssColor color;
  SpecifiedPaint fill = {"", SolidPaint::of({})};
  double fill_opacity = 1;
  FillRule fill_rule = FillRule::kNonZero;
  FillRule clip_rule = FillRule::kNonZero;
  SpecifiedPaint stroke;
  double stroke_opacity = 1;
  Length stroke_width = {1};
  LineCap line_cap = LineCap::kButt;
  LineJoin line_join = LineJoin::kMiter;
  double miter_limit = 4;
  std::vector<Length> dash_array;
  Length dash_offset;
  PaintOrder paint_order;
  bool crisp_edges = false;  // shape-rendering
  Visibility visibility = Visibility::kVisible;
  double font_size = 12;          // px; what programs for SVG take where nothing is said
  std::string_view marker_start;  // what url() holds; empty: none
  std::string_view marker_mid;
  std::string_view marker_end;
};

struct OwnProperties {
  double opacity = 1;
  Display display = Display::kInline;
  Overflow overflow = Overflow::kVisible;
  std::string_view clip_path;  // the value, when it is not "none"
  std::string_view mask;
  std::string_view filter;
  BlendMode blend_mode = BlendMode::kNormal;
  bool isolated = false;
  std::string_view baseline_shift;
  std::string_view text_decoration;
  std::string_view unicode_bidi;
  SolidPaint stop_color = SolidPaint::of({});
  double stop_opacity = 1;
  std::optional<Transform> transform;
  Length x, y, center_x, center_y, radius;
  std::optional<Length> radius_x, radius_y;  // unset: auto
  std::optional<Length> width, height;       // unset: auto
};

struct ComputedStyle : InheritedProperties, OwnProperties {};

}  // namespace libstyle::svg
