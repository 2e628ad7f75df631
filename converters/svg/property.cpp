// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/property.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "converters/svg/font_property.h"
#include "converters/svg/keyword.h"
#include "converters/svg/scanner.h"
#include "converters/svg/transform_list.h"

namespace libstyle::svg {
namespace {

using Text = std::string_view;
using Style = ComputedStyle;

// --- Values -------------------------------------------------------------------------------------

std::optional<SolidPaint> parse_solid(Text text) {
  if (equal_ignoring_case(text, "none")) return SolidPaint{};
  if (equal_ignoring_case(text, "currentColor")) {
    return SolidPaint{SolidPaint::Kind::kCurrentColor, {}};
  }
  const std::optional<CssColor> color = parse_css_color(text);
  if (!color) return std::nullopt;
  return SolidPaint::of(*color);
}

std::optional<SolidPaint> parse_stop_color(Text text) {
  return equal_ignoring_case(text, "none") ? std::nullopt : parse_solid(text);
}

std::optional<SpecifiedPaint> parse_paint(Text text) {
  SpecifiedPaint paint;
  if (equal_ignoring_case(text, "context-fill")) {
    paint.solid.kind = SolidPaint::Kind::kContextFill;
    return paint;
  }
  if (equal_ignoring_case(text, "context-stroke")) {
    paint.solid.kind = SolidPaint::Kind::kContextStroke;
    return paint;
  }
  Text rest;
  paint.reference = take_url(text, rest);
  const bool referred = rest.size() < text.size();
  rest = trimmed(rest);
  const std::size_t fragment = paint.reference.find('#');
  if (referred && paint.reference.substr(std::min(fragment, paint.reference.size())).size() < 2) {
    return std::nullopt;
  }
  if (!paint.reference.empty() && rest.empty()) return paint;
  const std::optional<SolidPaint> solid = parse_solid(rest);
  if (!solid) return std::nullopt;
  paint.solid = *solid;
  return paint;
}

std::optional<Length> parse_size(Text text) {
  const std::optional<Length> length = parse_length(text);
  return length && length->value >= 0 ? length : std::nullopt;
}

std::optional<std::vector<Length>> parse_dash_array(Text text) {
  if (equal_ignoring_case(text, "none")) return std::vector<Length>{};
  std::optional<std::vector<Length>> dashes = parse_length_list(text);
  if (dashes && std::ranges::any_of(*dashes, [](Length dash) { return dash.value < 0; })) {
    return std::nullopt;
  }
  return dashes;
}

// Below 1 is an error, but librsvg takes it: nothing is then pointed, as with 1.
std::optional<double> parse_miter_limit(Text text) {
  const std::optional<double> limit = parse_number(text);
  return limit ? std::optional(std::max(1.0, *limit)) : std::nullopt;
}

// --- Setters ------------------------------------------------------------------------------------

template <auto Member>
void copy(Style& to, const Style& from) {
  to.*Member = from.*Member;
}

template <typename Target, typename Value>
bool assign(Target& target, const std::optional<Value>& value) {
  if (value) target = *value;
  return value.has_value();
}

template <auto Member, auto Parse>
bool set(Style& style, const Style& /*parent*/, Text text) {
  return assign(style.*Member, Parse(text));
}

template <auto Member>
bool set_automatic_size(Style& style, const Style& /*parent*/, Text text) {
  if (equal_ignoring_case(text, "auto")) {
    (style.*Member).reset();
    return true;
  }
  return assign(style.*Member, parse_size(text));
}

// Keeps the value itself, for whoever draws what it names.
template <auto Member>
bool set_text(Style& style, const Style& /*parent*/, Text text) {
  const bool none = equal_ignoring_case(text, "none") || equal_ignoring_case(text, "normal");
  style.*Member = none ? Text() : text;
  return true;
}

template <auto Member>
bool set_url(Style& style, const Style& /*parent*/, Text text) {
  Text rest;
  const Text url = take_url(text, rest);
  if (!trimmed(rest).empty() && !url.empty()) return false;
  if (url.empty() && !equal_ignoring_case(text, "none")) return false;
  style.*Member = url;
  return true;
}

bool set_color(Style& style, const Style& parent, Text text) {
  if (equal_ignoring_case(text, "currentColor")) {
    style.color = parent.color;
    return true;
  }
  return assign(style.color, parse_css_color(text));
}

bool set_font_size(Style& style, const Style& parent, Text text) {
  return assign(style.font_size, parse_font_size(text, parent.font_size));
}

bool set_font_weight(Style& style, const Style& parent, Text text) {
  return assign(style.font_weight, parse_font_weight(text, parent.font_weight));
}

bool set_font(Style& style, const Style& parent, Text text) {
  const std::optional<Font> font = parse_font(text, parent.font_size, parent.font_weight);
  if (!font) return false;
  style.font_family = font->family;
  style.font_style = font->style;
  style.font_variant = font->variant;
  style.font_stretch = font->stretch;
  style.font_size = font->size;
  style.font_weight = font->weight;
  return true;
}

void copy_font(Style& to, const Style& from) {
  to.font_family = from.font_family;
  to.font_style = from.font_style;
  to.font_variant = from.font_variant;
  to.font_stretch = from.font_stretch;
  to.font_size = from.font_size;
  to.font_weight = from.font_weight;
}

bool set_marker(Style& style, const Style& parent, Text text) {
  return set_url<&Style::marker_start>(style, parent, text) &&
         set_url<&Style::marker_mid>(style, parent, text) &&
         set_url<&Style::marker_end>(style, parent, text);
}

void copy_marker(Style& to, const Style& from) {
  to.marker_start = from.marker_start;
  to.marker_mid = from.marker_mid;
  to.marker_end = from.marker_end;
}

bool set_transform(Style& style, const Style& /*parent*/, Text text) {
  return assign(style.transform, parse_transform_property(text));
}

// librsvg does not let transforms be inherited, not even by "inherit".
void keep(Style& /*to*/, const Style& /*from*/) {}

std::optional<FillRule> parse_fill_rule(Text text) {
  return find_keyword<FillRule>(text,
                                {{"nonzero", FillRule::kNonZero}, {"evenodd", FillRule::kEvenOdd}});
}

std::optional<LineCap> parse_line_cap(Text text) {
  return find_keyword<LineCap>(
      text, {{"butt", LineCap::kButt}, {"round", LineCap::kRound}, {"square", LineCap::kSquare}});
}

// The joins that SVG 2 adds fall back to a miter.
std::optional<LineJoin> parse_line_join(Text text) {
  return find_keyword<LineJoin>(text, {{"miter", LineJoin::kMiter},
                                       {"round", LineJoin::kRound},
                                       {"bevel", LineJoin::kBevel},
                                       {"miter-clip", LineJoin::kMiter},
                                       {"arcs", LineJoin::kMiter}});
}

std::optional<Visibility> parse_visibility(Text text) {
  return find_keyword<Visibility>(text, {{"visible", Visibility::kVisible},
                                         {"hidden", Visibility::kHidden},
                                         {"collapse", Visibility::kHidden}});
}

// Everything but "none" draws.
std::optional<Display> parse_display(Text text) {
  return equal_ignoring_case(text, "none") ? Display::kNone : Display::kInline;
}

std::optional<Overflow> parse_overflow(Text text) {
  return find_keyword<Overflow>(text, {{"visible", Overflow::kVisible},
                                       {"auto", Overflow::kVisible},
                                       {"hidden", Overflow::kHidden},
                                       {"scroll", Overflow::kHidden}});
}

// Words that only the layout of text knows. No value that is meant is longer than this.
std::optional<Text> parse_words(Text text) {
  constexpr std::size_t kLongest = 500;
  return text.empty() || text.size() > kLongest ? std::nullopt : std::optional(text);
}

std::optional<Length> parse_letter_spacing(Text text) {
  return equal_ignoring_case(text, "normal") ? Length{} : parse_length(text);
}

std::optional<Text> parse_text_anchor(Text text) {
  return find_word(text, {"start", "middle", "end"});
}

std::optional<Text> parse_direction(Text text) { return find_word(text, {"ltr", "rtl"}); }

// The words of SVG 1.1, and those of CSS.
std::optional<Text> parse_writing_mode(Text text) {
  return find_word(text, {"lr", "lr-tb", "rl", "rl-tb", "tb", "tb-rl", "horizontal-tb",
                          "vertical-rl", "vertical-lr"});
}

std::optional<Text> parse_text_orientation(Text text) {
  return find_word(text, {"mixed", "upright", "sideways"});
}

std::optional<BlendMode> parse_blend_mode(Text text) {
  const auto is_named = [text](Text name) { return equal_ignoring_case(text, name); };
  const auto* const found = std::ranges::find_if(kBlendModeNames, is_named);
  if (found == kBlendModeNames.end()) return std::nullopt;
  return static_cast<BlendMode>(found - kBlendModeNames.begin());
}

// Whether edges are crisp, rather than smoothed.
std::optional<bool> parse_shape_rendering(Text text) {
  return find_keyword<bool>(text, {{"auto", false},
                                   {"geometricPrecision", false},
                                   {"optimizeSpeed", true},
                                   {"crispEdges", true}});
}

std::optional<bool> parse_isolation(Text text) {
  return find_keyword<bool>(text, {{"auto", false}, {"isolate", true}});
}

// --- The table, sorted by name ------------------------------------------------------------------

template <auto Member, auto Parse>
constexpr Property property(Text name) {
  return {name, set<Member, Parse>, copy<Member>};
}

template <auto Member>
constexpr Property automatic_size(Text name) {
  return {name, set_automatic_size<Member>, copy<Member>};
}

template <auto Member>
constexpr Property text_property(Text name) {
  return {name, set_text<Member>, copy<Member>};
}

template <auto Member>
constexpr Property url_property(Text name) {
  return {name, set_url<Member>, copy<Member>};
}

constexpr Property kProperties[] = {
    property<&Style::baseline_shift, parse_words>("baseline-shift"),
    text_property<&Style::clip_path>("clip-path"),
    property<&Style::clip_rule, parse_fill_rule>("clip-rule"),
    {"color", set_color, copy<&Style::color>},
    property<&Style::center_x, parse_length>("cx"),
    property<&Style::center_y, parse_length>("cy"),
    property<&Style::direction, parse_direction>("direction"),
    property<&Style::display, parse_display>("display"),
    property<&Style::fill, parse_paint>("fill"),
    property<&Style::fill_opacity, parse_opacity>("fill-opacity"),
    property<&Style::fill_rule, parse_fill_rule>("fill-rule"),
    text_property<&Style::filter>("filter"),
    {"font", set_font, copy_font},
    property<&Style::font_family, parse_words>("font-family"),
    {"font-size", set_font_size, copy<&Style::font_size>},
    property<&Style::font_stretch, parse_font_stretch>("font-stretch"),
    property<&Style::font_style, parse_font_style>("font-style"),
    property<&Style::font_variant, parse_font_variant>("font-variant"),
    {"font-weight", set_font_weight, copy<&Style::font_weight>},
    automatic_size<&Style::height>("height"),
    property<&Style::isolated, parse_isolation>("isolation"),
    property<&Style::letter_spacing, parse_letter_spacing>("letter-spacing"),
    {"marker", set_marker, copy_marker},
    url_property<&Style::marker_end>("marker-end"),
    url_property<&Style::marker_mid>("marker-mid"),
    url_property<&Style::marker_start>("marker-start"),
    text_property<&Style::mask>("mask"),
    property<&Style::blend_mode, parse_blend_mode>("mix-blend-mode"),
    property<&Style::opacity, parse_opacity>("opacity"),
    property<&Style::overflow, parse_overflow>("overflow"),
    property<&Style::paint_order, parse_paint_order>("paint-order"),
    property<&Style::radius, parse_size>("r"),
    automatic_size<&Style::radius_x>("rx"),
    automatic_size<&Style::radius_y>("ry"),
    property<&Style::crisp_edges, parse_shape_rendering>("shape-rendering"),
    property<&Style::stop_color, parse_stop_color>("stop-color"),
    property<&Style::stop_opacity, parse_opacity>("stop-opacity"),
    property<&Style::stroke, parse_paint>("stroke"),
    property<&Style::dash_array, parse_dash_array>("stroke-dasharray"),
    property<&Style::dash_offset, parse_length>("stroke-dashoffset"),
    property<&Style::line_cap, parse_line_cap>("stroke-linecap"),
    property<&Style::line_join, parse_line_join>("stroke-linejoin"),
    property<&Style::miter_limit, parse_miter_limit>("stroke-miterlimit"),
    property<&Style::stroke_opacity, parse_opacity>("stroke-opacity"),
    property<&Style::stroke_width, parse_length>("stroke-width"),
    property<&Style::text_anchor, parse_text_anchor>("text-anchor"),
    property<&Style::text_decoration, parse_words>("text-decoration"),
    property<&Style::text_orientation, parse_text_orientation>("text-orientation"),
    {"transform", set_transform, keep},
    property<&Style::unicode_bidi, parse_words>("unicode-bidi"),
    property<&Style::visibility, parse_visibility>("visibility"),
    automatic_size<&Style::width>("width"),
    property<&Style::writing_mode, parse_writing_mode>("writing-mode"),
    property<&Style::x, parse_length>("x"),
    property<&Style::language, parse_words>("xml:lang"),
    property<&Style::white_space, parse_words>("xml:space"),
    property<&Style::y, parse_length>("y"),
};
static_assert(std::ranges::is_sorted(kProperties, {}, &Property::name));

}  // namespace

const Property* find_property(std::string_view name) {
  const auto* const found = std::ranges::lower_bound(kProperties, name, {}, &Property::name);
  return found != std::end(kProperties) && found->name == name ? found : nullptr;
}

bool apply(const Property& property, std::string_view value, ComputedStyle& style,
           const ComputedStyle& parent) {
  value = trimmed(value);
  if (equal_ignoring_case(value, "inherit")) {
    property.copy(style, parent);
    return true;
  }
  return property.set(style, parent, value);
}

std::string_view take_url(std::string_view text, std::string_view& rest) {
  rest = text;
  if (text.size() < 4 || !equal_ignoring_case(text.substr(0, 4), "url(")) return {};
  const std::size_t end = std::min(text.find(')'), text.size());  // CSS closes what is left open
  std::string_view url = trimmed(text.substr(4, end - 4));
  rest = text.substr(std::min(end + 1, text.size()));
  if (url.size() >= 2 && (url[0] == '"' || url[0] == '\'') && url.back() == url[0]) {
    url = trimmed(url.substr(1, url.size() - 2));
  }
  return url;
}

}  // namespace libstyle::svg
