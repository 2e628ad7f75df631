// SPDX-License-Identifier: Apache-2.0
// The values of the properties that choose a font (CSS 2.1, chapter 15).
#pragma once

#include <optional>
#include <string_view>

namespace libstyle::svg {

// Words are those of the text, or of a table here; they mean something to what lays out text only.
std::optional<std::string_view> parse_font_style(std::string_view text);
std::optional<std::string_view> parse_font_variant(std::string_view text);
std::optional<std::string_view> parse_font_stretch(std::string_view text);

// In px.
std::optional<double> parse_font_size(std::string_view text, double parent_size);
std::optional<int> parse_font_weight(std::string_view text, int parent_weight);

// What `font` says; all that it leaves out is initial.
struct Font {
  std::string_view family;  // empty: initial, as are the words
  std::string_view style;
  std::string_view variant;
  std::string_view stretch;
  double size = 16;  // px
  int weight = 400;
};
std::optional<Font> parse_font(std::string_view text, double parent_size, int parent_weight);

}  // namespace libstyle::svg
