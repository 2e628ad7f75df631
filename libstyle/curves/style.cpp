// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/style.h"

#include <array>
#include <cmath>

namespace libstyle {
namespace {

constexpr std::string_view kHexDigits = "0123456789abcdef";

void append_hex(std::string& text, std::uint8_t value) {
  text += kHexDigits[value >> 4];
  text += kHexDigits[value & 15];
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::string to_text(Color color) {
  std::string text = "#";
  append_hex(text, color.red);
  append_hex(text, color.green);
  append_hex(text, color.blue);
  if (color.alpha != 255) append_hex(text, color.alpha);
  return text;
}

std::vector<Color> map_channels(
    std::span<const Color> colors,
    const std::function<std::vector<double>(std::span<const double>)>& map) {
  std::vector<Color> result;
  for (std::uint8_t Color::*channel : {&Color::red, &Color::green, &Color::blue, &Color::alpha}) {
    std::vector<double> values;
    for (const Color& color : colors) values.push_back(color.*channel);
    const std::vector<double> mapped = map(values);
    result.resize(mapped.size());
    for (std::size_t i = 0; i < mapped.size(); ++i) {
      result[i].*channel = static_cast<std::uint8_t>(std::lround(mapped[i]));
    }
  }
  return result;
}

std::optional<Color> parse_color(std::string_view text) {
  if ((text.size() != 7 && text.size() != 9) || text.front() != '#') return std::nullopt;
  std::array<std::uint8_t, 4> channels = {0, 0, 0, 255};
  for (std::size_t i = 1; i < text.size(); i += 2) {
    const int high = hex_digit(text[i]), low = hex_digit(text[i + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    channels[i / 2] = static_cast<std::uint8_t>(high * 16 + low);
  }
  return Color{channels[0], channels[1], channels[2], channels[3]};
}

}  // namespace libstyle
