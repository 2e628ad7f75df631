// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/view_box.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

bool take_align(std::string_view& word, std::string_view axis, Align& align) {
  constexpr std::string_view kNames[] = {"min", "mid", "max"};
  if (!word.starts_with(axis)) return false;
  const auto found = std::ranges::find(kNames, word.substr(axis.size(), 3));
  if (found == std::end(kNames)) return false;
  align = static_cast<Align>(found - std::begin(kNames));
  word.remove_prefix(axis.size() + 3);
  return true;
}

// In lower case.
std::string take_next_word(Scanner& scanner) {
  scanner.skip_spaces();
  std::string word(scanner.take_word());
  std::ranges::transform(word, word.begin(), to_lower);
  return word;
}

// Writers turn millimetres into px in their own way, so that the width of a page and that of its
// viewBox often differ in their last digits where the same is meant. No coordinate is to move then.
bool nearly_equal(double a, double b) { return std::abs(a - b) < 1e-12 * std::abs(b); }

double scale_between(double from, double to) { return nearly_equal(from, to) ? 1 : to / from; }

// Where the low edge of `size` comes to lie in `available`.
double aligned(Align align, double available, double size) {
  if (nearly_equal(size, available)) return 0;
  return static_cast<double>(align) / 2 * (available - size);
}

}  // namespace

std::optional<Rectangle> parse_view_box(std::string_view text) {
  Scanner scanner(trimmed(text));
  Rectangle box;
  for (double* const number : {&box.x, &box.y, &box.width, &box.height}) {
    if (!scanner.take_css_number(*number)) return std::nullopt;
    if (scanner.peek() == '%' || !scanner.take_word().empty()) return std::nullopt;
    scanner.skip_separator();
  }
  if (box.width < 0 || box.height < 0) return std::nullopt;
  return box;
}

std::optional<AspectRatio> parse_aspect_ratio(std::string_view text) {
  Scanner scanner(text);
  AspectRatio ratio;
  std::string word = take_next_word(scanner);
  if (word == "defer") {
    ratio.defer = true;
    word = take_next_word(scanner);
  }
  std::string_view align = word;
  if (align == "none") {
    ratio.preserved = false;
  } else if (!take_align(align, "x", ratio.x) || !take_align(align, "y", ratio.y) ||
             !align.empty()) {
    return std::nullopt;
  }
  ratio.slice = take_next_word(scanner) == "slice";
  return ratio;
}

std::optional<View> read_view(pugi::xml_node element) {
  View view;
  if (const pugi::xml_attribute attribute = element.attribute("viewBox")) {
    view.view_box = parse_view_box(attribute.value());
    if (!view.view_box) return std::nullopt;
  }
  if (const pugi::xml_attribute attribute = element.attribute("preserveAspectRatio")) {
    const std::optional<AspectRatio> ratio = parse_aspect_ratio(attribute.value());
    if (!ratio) return std::nullopt;
    view.ratio = *ratio;
  }
  return view;
}

std::optional<Transform> viewport_from_view_box(const Rectangle& viewport,
                                                const Rectangle& view_box, AspectRatio ratio) {
  if (!(view_box.width > 0 && view_box.height > 0)) return std::nullopt;
  double scale_x = scale_between(view_box.width, viewport.width);
  double scale_y = scale_between(view_box.height, viewport.height);
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
