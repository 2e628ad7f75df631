// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/view_box.h"

#include <algorithm>

#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

bool take_align(std::string_view& word, std::string_view axis, Align& align) {
  constexpr std::string_view kNames[] = {"Min", "Mid", "Max"};
  if (!word.starts_with(axis)) return false;
  const auto found = std::ranges::find(kNames, word.substr(axis.size(), 3));
  if (found == std::end(kNames)) return false;
  align = static_cast<Align>(found - std::begin(kNames));
  word.remove_prefix(axis.size() + 3);
  return true;
}

std::string_view take_next_word(Scanner& scanner) {
  scanner.skip_spaces();
  return scanner.take_word();
}

// Where the low edge of `size` comes to lie in `available`.
double aligned(Align align, double available, double size) {
  return static_cast<double>(align) / 2 * (available - size);
}

}  // namespace

std::optional<Rectangle> parse_view_box(std::string_view text) {
  const NumberList list = parse_number_list(text);
  if (!list.complete || list.numbers.size() != 4) return std::nullopt;
  const Rectangle box = {list.numbers[0], list.numbers[1], list.numbers[2], list.numbers[3]};
  if (box.width < 0 || box.height < 0) return std::nullopt;
  return box;
}

std::optional<AspectRatio> parse_aspect_ratio(std::string_view text) {
  Scanner scanner(trimmed(text));
  AspectRatio ratio;
  std::string_view word = take_next_word(scanner);
  if (word == "defer") {
    ratio.defer = true;
    word = take_next_word(scanner);
  }
  if (word == "none") {
    ratio.preserved = false;
  } else if (!take_align(word, "x", ratio.x) || !take_align(word, "Y", ratio.y) || !word.empty()) {
    return std::nullopt;
  }
  word = take_next_word(scanner);
  ratio.slice = word == "slice";
  if (!scanner.at_end() || !(word.empty() || word == "meet" || ratio.slice)) return std::nullopt;
  return ratio;
}

std::optional<Transform> viewport_from_view_box(const Rectangle& viewport,
                                                const Rectangle& view_box, AspectRatio ratio) {
  if (!(view_box.width > 0 && view_box.height > 0)) return std::nullopt;
  double scale_x = viewport.width / view_box.width, scale_y = viewport.height / view_box.height;
  if (ratio.preserved) {
    scale_x = ratio.slice ? std::max(scale_x, scale_y) : std::min(scale_x, scale_y);
    scale_y = scale_x;
  }
  const Point low = {viewport.x + aligned(ratio.x, viewport.width, scale_x * view_box.width),
                     viewport.y + aligned(ratio.y, viewport.height, scale_y * view_box.height)};
  const Transform result = {
      scale_x, 0, 0, scale_y, low.x - scale_x * view_box.x, low.y - scale_y * view_box.y};
  if (!result.is_finite() || !inverse(result)) return std::nullopt;
  return result;
}

}  // namespace libstyle::svg
