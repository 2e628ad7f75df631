// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/font_property.h"

#include <algorithm>

#include "converters/svg/keyword.h"
#include "converters/svg/length.h"

namespace libstyle::svg {
namespace {

// Takes the word at the front of `text` off it.
std::string_view take_front(std::string_view& text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_of(" \t\r\n\f"), text.size());
  const std::string_view word = text.substr(0, end);
  text = trimmed(text.substr(end));
  return word;
}

// Style, variant, weight and stretch come first, in any order.
bool take_trait(std::string_view word, Font& font, int parent_weight) {
  if (equal_ignoring_case(word, "normal")) return true;
  if (const auto style = parse_font_style(word)) {
    font.style = *style;
  } else if (const auto variant = parse_font_variant(word)) {
    font.variant = *variant;
  } else if (const auto weight = parse_font_weight(word, parent_weight)) {
    font.weight = *weight;
  } else if (const auto stretch = parse_font_stretch(word)) {
    font.stretch = *stretch;
  } else {
    return false;
  }
  return true;
}

}  // namespace

std::optional<std::string_view> parse_font_style(std::string_view text) {
  return find_word(text, {"normal", "italic", "oblique"});
}

std::optional<std::string_view> parse_font_variant(std::string_view text) {
  return find_word(text, {"normal", "small-caps"});
}

std::optional<std::string_view> parse_font_stretch(std::string_view text) {
  return find_word(text,
                   {"normal", "ultra-condensed", "extra-condensed", "condensed", "semi-condensed",
                    "semi-expanded", "expanded", "extra-expanded", "ultra-expanded"});
}

// Section 15.7, with its suggested factor of 1.2 between neighbours.
std::optional<double> parse_font_size(std::string_view text, double parent_size) {
  const auto keyword = find_keyword<double>(text, {{"xx-small", 16 / 1.728},
                                                   {"x-small", 16 / 1.44},
                                                   {"small", 16 / 1.2},
                                                   {"medium", 16},
                                                   {"large", 16 * 1.2},
                                                   {"x-large", 16 * 1.44},
                                                   {"xx-large", 16 * 1.728},
                                                   {"smaller", parent_size / 1.2},
                                                   {"larger", parent_size * 1.2}});
  if (keyword) return keyword;
  const std::optional<Length> length = parse_length(text);
  if (!length || length->value < 0) return std::nullopt;
  if (length->unit == LengthUnit::kPercent) return length->value / 100 * parent_size;
  return resolve(*length, LengthAxis::kDiagonal, {0, 0, parent_size});
}

// The steps of "bolder" and "lighter" are those of CSS Fonts 3, section 3.2.
std::optional<int> parse_font_weight(std::string_view text, int parent_weight) {
  const int bolder = parent_weight < 350 ? 400 : parent_weight < 550 ? 700 : 900;
  const int lighter = parent_weight < 550 ? 100 : parent_weight < 750 ? 400 : 700;
  const auto keyword = find_keyword<int>(
      text, {{"normal", 400}, {"bold", 700}, {"bolder", bolder}, {"lighter", lighter}});
  if (keyword) return keyword;
  const std::optional<double> number = parse_number(text);
  if (!number || !(*number >= 1 && *number <= 1000)) return std::nullopt;
  return static_cast<int>(*number);
}

// Section 15.8: traits, size, perhaps "/" and the height of a line, families. The names of the
// fonts of a desktop ("caption") are not known here.
std::optional<Font> parse_font(std::string_view text, double parent_size, int parent_weight) {
  Font font;
  std::string_view rest = text;
  std::string_view word = take_front(rest);
  while (take_trait(word, font, parent_weight)) word = take_front(rest);
  const std::optional<double> size = parse_font_size(word.substr(0, word.find('/')), parent_size);
  if (!size) return std::nullopt;
  font.size = *size;
  const bool slash_follows = rest.starts_with('/');
  if (slash_follows) rest.remove_prefix(1);
  if (slash_follows || word.ends_with('/')) take_front(rest);
  if (rest.empty()) return std::nullopt;
  font.family = rest;
  return font;
}

}  // namespace libstyle::svg
