// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/css_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "converters/svg/angle.h"
#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

struct NamedColor {
  std::string_view name;
  std::uint32_t rgb;
};

// The names of CSS Color level 4, section 6.1, in the order of the alphabet.
constexpr NamedColor kNamedColors[] = {{"aliceblue", 0xf0f8ff},
                                       {"antiquewhite", 0xfaebd7},
                                       {"aqua", 0x00ffff},
                                       {"aquamarine", 0x7fffd4},
                                       {"azure", 0xf0ffff},
                                       {"beige", 0xf5f5dc},
                                       {"bisque", 0xffe4c4},
                                       {"black", 0x000000},
                                       {"blanchedalmond", 0xffebcd},
                                       {"blue", 0x0000ff},
                                       {"blueviolet", 0x8a2be2},
                                       {"brown", 0xa52a2a},
                                       {"burlywood", 0xdeb887},
                                       {"cadetblue", 0x5f9ea0},
                                       {"chartreuse", 0x7fff00},
                                       {"chocolate", 0xd2691e},
                                       {"coral", 0xff7f50},
                                       {"cornflowerblue", 0x6495ed},
                                       {"cornsilk", 0xfff8dc},
                                       {"crimson", 0xdc143c},
                                       {"cyan", 0x00ffff},
                                       {"darkblue", 0x00008b},
                                       {"darkcyan", 0x008b8b},
                                       {"darkgoldenrod", 0xb8860b},
                                       {"darkgray", 0xa9a9a9},
                                       {"darkgreen", 0x006400},
                                       {"darkgrey", 0xa9a9a9},
                                       {"darkkhaki", 0xbdb76b},
                                       {"darkmagenta", 0x8b008b},
                                       {"darkolivegreen", 0x556b2f},
                                       {"darkorange", 0xff8c00},
                                       {"darkorchid", 0x9932cc},
                                       {"darkred", 0x8b0000},
                                       {"darksalmon", 0xe9967a},
                                       {"darkseagreen", 0x8fbc8f},
                                       {"darkslateblue", 0x483d8b},
                                       {"darkslategray", 0x2f4f4f},
                                       {"darkslategrey", 0x2f4f4f},
                                       {"darkturquoise", 0x00ced1},
                                       {"darkviolet", 0x9400d3},
                                       {"deeppink", 0xff1493},
                                       {"deepskyblue", 0x00bfff},
                                       {"dimgray", 0x696969},
                                       {"dimgrey", 0x696969},
                                       {"dodgerblue", 0x1e90ff},
                                       {"firebrick", 0xb22222},
                                       {"floralwhite", 0xfffaf0},
                                       {"forestgreen", 0x228b22},
                                       {"fuchsia", 0xff00ff},
                                       {"gainsboro", 0xdcdcdc},
                                       {"ghostwhite", 0xf8f8ff},
                                       {"gold", 0xffd700},
                                       {"goldenrod", 0xdaa520},
                                       {"gray", 0x808080},
                                       {"green", 0x008000},
                                       {"greenyellow", 0xadff2f},
                                       {"grey", 0x808080},
                                       {"honeydew", 0xf0fff0},
                                       {"hotpink", 0xff69b4},
                                       {"indianred", 0xcd5c5c},
                                       {"indigo", 0x4b0082},
                                       {"ivory", 0xfffff0},
                                       {"khaki", 0xf0e68c},
                                       {"lavender", 0xe6e6fa},
                                       {"lavenderblush", 0xfff0f5},
                                       {"lawngreen", 0x7cfc00},
                                       {"lemonchiffon", 0xfffacd},
                                       {"lightblue", 0xadd8e6},
                                       {"lightcoral", 0xf08080},
                                       {"lightcyan", 0xe0ffff},
                                       {"lightgoldenrodyellow", 0xfafad2},
                                       {"lightgray", 0xd3d3d3},
                                       {"lightgreen", 0x90ee90},
                                       {"lightgrey", 0xd3d3d3},
                                       {"lightpink", 0xffb6c1},
                                       {"lightsalmon", 0xffa07a},
                                       {"lightseagreen", 0x20b2aa},
                                       {"lightskyblue", 0x87cefa},
                                       {"lightslategray", 0x778899},
                                       {"lightslategrey", 0x778899},
                                       {"lightsteelblue", 0xb0c4de},
                                       {"lightyellow", 0xffffe0},
                                       {"lime", 0x00ff00},
                                       {"limegreen", 0x32cd32},
                                       {"linen", 0xfaf0e6},
                                       {"magenta", 0xff00ff},
                                       {"maroon", 0x800000},
                                       {"mediumaquamarine", 0x66cdaa},
                                       {"mediumblue", 0x0000cd},
                                       {"mediumorchid", 0xba55d3},
                                       {"mediumpurple", 0x9370db},
                                       {"mediumseagreen", 0x3cb371},
                                       {"mediumslateblue", 0x7b68ee},
                                       {"mediumspringgreen", 0x00fa9a},
                                       {"mediumturquoise", 0x48d1cc},
                                       {"mediumvioletred", 0xc71585},
                                       {"midnightblue", 0x191970},
                                       {"mintcream", 0xf5fffa},
                                       {"mistyrose", 0xffe4e1},
                                       {"moccasin", 0xffe4b5},
                                       {"navajowhite", 0xffdead},
                                       {"navy", 0x000080},
                                       {"oldlace", 0xfdf5e6},
                                       {"olive", 0x808000},
                                       {"olivedrab", 0x6b8e23},
                                       {"orange", 0xffa500},
                                       {"orangered", 0xff4500},
                                       {"orchid", 0xda70d6},
                                       {"palegoldenrod", 0xeee8aa},
                                       {"palegreen", 0x98fb98},
                                       {"paleturquoise", 0xafeeee},
                                       {"palevioletred", 0xdb7093},
                                       {"papayawhip", 0xffefd5},
                                       {"peachpuff", 0xffdab9},
                                       {"peru", 0xcd853f},
                                       {"pink", 0xffc0cb},
                                       {"plum", 0xdda0dd},
                                       {"powderblue", 0xb0e0e6},
                                       {"purple", 0x800080},
                                       {"rebeccapurple", 0x663399},
                                       {"red", 0xff0000},
                                       {"rosybrown", 0xbc8f8f},
                                       {"royalblue", 0x4169e1},
                                       {"saddlebrown", 0x8b4513},
                                       {"salmon", 0xfa8072},
                                       {"sandybrown", 0xf4a460},
                                       {"seagreen", 0x2e8b57},
                                       {"seashell", 0xfff5ee},
                                       {"sienna", 0xa0522d},
                                       {"silver", 0xc0c0c0},
                                       {"skyblue", 0x87ceeb},
                                       {"slateblue", 0x6a5acd},
                                       {"slategray", 0x708090},
                                       {"slategrey", 0x708090},
                                       {"snow", 0xfffafa},
                                       {"springgreen", 0x00ff7f},
                                       {"steelblue", 0x4682b4},
                                       {"tan", 0xd2b48c},
                                       {"teal", 0x008080},
                                       {"thistle", 0xd8bfd8},
                                       {"tomato", 0xff6347},
                                       {"turquoise", 0x40e0d0},
                                       {"violet", 0xee82ee},
                                       {"wheat", 0xf5deb3},
                                       {"white", 0xffffff},
                                       {"whitesmoke", 0xf5f5f5},
                                       {"yellow", 0xffff00},
                                       {"yellowgreen", 0x9acd32}};

Color from_rgb(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
          static_cast<std::uint8_t>(rgb)};
}

// `value` in 0 .. 1, or put there.
std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::floor(std::clamp(value, 0.0, 1.0) * 255 + 0.5));
}

std::optional<CssColor> parse_name(std::string_view text) {
  std::string name(text);
  std::ranges::transform(name, name.begin(), to_lower);
  if (name == "transparent") return CssColor{{}, 0};
  const auto found = std::ranges::lower_bound(kNamedColors, name, {}, &NamedColor::name);
  if (found == std::end(kNamedColors) || found->name != name) return std::nullopt;
  return CssColor{from_rgb(found->rgb), 1};
}

std::optional<std::uint8_t> hex_digit(char c) {
  if (is_digit(c)) return static_cast<std::uint8_t>(c - '0');
  const char lower = to_lower(c);
  if (lower < 'a' || lower > 'f') return std::nullopt;
  return static_cast<std::uint8_t>(lower - 'a' + 10);
}

// 3, 4, 6 or 8 hexadecimal digits.
std::optional<CssColor> parse_hex(std::string_view digits) {
  const bool is_short = digits.size() == 3 || digits.size() == 4;
  if (!is_short && digits.size() != 6 && digits.size() != 8) return std::nullopt;
  std::array<std::uint8_t, 4> channels = {0, 0, 0, 255};
  const std::size_t width = is_short ? 1 : 2;
  for (std::size_t i = 0; i < digits.size() / width; ++i) {
    const auto high = hex_digit(digits[i * width]);
    const auto low = hex_digit(digits[i * width + width - 1]);
    if (!high || !low) return std::nullopt;
    channels[i] = static_cast<std::uint8_t>(16 * *high + *low);
  }
  return CssColor{{channels[0], channels[1], channels[2]}, channels[3] / 255.0};
}

// One argument of a colour function.
struct Argument {
  double value = 0;  // a percentage is divided by 100, an angle in degrees
  bool percent = false;
};

bool take_argument(Scanner& scanner, Argument& argument) {
  if (!scanner.take_css_number(argument.value)) return false;
  argument.percent = scanner.take('%');
  if (argument.percent) argument.value /= 100;
  return true;
}

bool take_hue(Scanner& scanner, Argument& argument) {
  if (!scanner.take_css_number(argument.value)) return false;
  const std::string_view unit = scanner.take_word();
  const std::optional<double> degrees = unit.empty() ? 1 : degrees_per_unit(unit);
  argument.value *= degrees.value_or(0);
  return degrees && std::isfinite(argument.value);
}

struct Arguments {
  std::array<Argument, 3> channels;
  double alpha = 1;
};

// "(1, 2, 3)", "(1, 2, 3, .5)", "(1 2 3)" or "(1 2 3 / .5)" up to the end of the text.
bool take_arguments(Scanner& scanner, bool begins_with_hue, Arguments& arguments) {
  if (!scanner.take('(')) return false;
  scanner.skip_spaces();
  bool commas = false;
  for (std::size_t i = 0; i < 3; ++i) {
    Argument& channel = arguments.channels[i];
    if (!(i == 0 && begins_with_hue ? take_hue(scanner, channel)
                                    : take_argument(scanner, channel))) {
      return false;
    }
    const bool comma = i < 2 && scanner.skip_separator();
    if (i == 0) commas = comma;
    if (i < 2 && comma != commas) return false;
  }
  scanner.skip_spaces();
  if (scanner.take(commas ? ',' : '/')) {
    scanner.skip_spaces();
    Argument alpha;
    if (!take_argument(scanner, alpha)) return false;
    arguments.alpha = std::clamp(alpha.value, 0.0, 1.0);
    scanner.skip_spaces();
  }
  scanner.take(')');  // CSS closes what is left open
  return scanner.at_end();
}

std::optional<CssColor> make_rgb(const Arguments& arguments) {
  const auto& [red, green, blue] = arguments.channels;
  if (red.percent != green.percent || green.percent != blue.percent) return std::nullopt;
  const double range = red.percent ? 1 : 255;
  return CssColor{
      {to_byte(red.value / range), to_byte(green.value / range), to_byte(blue.value / range)},
      arguments.alpha};
}

// CSS Color level 4, section 7.1.
std::optional<CssColor> make_hsl(const Arguments& arguments) {
  const auto& [hue, saturation, lightness] = arguments.channels;
  if (!saturation.percent || !lightness.percent) return std::nullopt;
  const double light = std::clamp(lightness.value, 0.0, 1.0);
  const double chroma = std::clamp(saturation.value, 0.0, 1.0) * std::min(light, 1 - light);
  const double twelfths = hue.value / 30 - 12 * std::floor(hue.value / 360);
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + twelfths, 12);
    return to_byte(light - chroma * std::clamp(std::min(k - 3, 9 - k), -1.0, 1.0));
  };
  return CssColor{{channel(0), channel(8), channel(4)}, arguments.alpha};
}

std::optional<CssColor> parse_function(std::string_view text) {
  Scanner scanner(text);
  const std::string_view name = scanner.take_word();
  const bool is_rgb = equal_ignoring_case(name, "rgb") || equal_ignoring_case(name, "rgba");
  const bool is_hsl = equal_ignoring_case(name, "hsl") || equal_ignoring_case(name, "hsla");
  Arguments arguments;
  if (!(is_rgb || is_hsl) || !take_arguments(scanner, is_hsl, arguments)) return std::nullopt;
  return is_rgb ? make_rgb(arguments) : make_hsl(arguments);
}

}  // namespace

std::optional<CssColor> parse_css_color(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('#')) return parse_hex(text.substr(1));
  if (text.find('(') != std::string_view::npos) return parse_function(text);
  return parse_name(text);
}

}  // namespace libstyle::svg
