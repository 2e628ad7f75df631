// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/length.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

struct UnitName {
  std::string_view name;
  LengthUnit unit;
};

constexpr UnitName kUnitNames[] = {
    {"", LengthUnit::kPx},   {"px", LengthUnit::kPx}, {"pt", LengthUnit::kPt},
    {"pc", LengthUnit::kPc}, {"mm", LengthUnit::kMm}, {"cm", LengthUnit::kCm},
    {"in", LengthUnit::kIn}, {"em", LengthUnit::kEm}, {"ex", LengthUnit::kEx}};

bool take_unit(Scanner& scanner, LengthUnit& unit) {
  if (scanner.take('%')) {
    unit = LengthUnit::kPercent;
    return true;
  }
  const std::optional<LengthUnit> named = length_unit(scanner.take_word());
  if (named) unit = *named;
  return named.has_value();
}

bool take_length(Scanner& scanner, Length& length) {
  return scanner.take_css_number(length.value) && take_unit(scanner, length.unit);
}

double percentage_base(LengthAxis axis, const LengthContext& context) {
  const double width = context.viewport_width, height = context.viewport_height;
  switch (axis) {
    case LengthAxis::kHorizontal:
      return width;
    case LengthAxis::kVertical:
      return height;
    case LengthAxis::kDiagonal:
      return std::sqrt((width * width + height * height) / 2);
  }
  return 0;
}

// Px are no unit of a share, but librsvg takes them.
std::optional<double> to_share(std::optional<Length> length) {
  if (!length) return std::nullopt;
  const bool percent = length->unit == LengthUnit::kPercent;
  if (!percent && length->unit != LengthUnit::kPx) return std::nullopt;
  return std::clamp(percent ? length->value / 100 : length->value, 0.0, 1.0);
}

double px_per_unit(LengthUnit unit) {
  constexpr double kInch = 96;
  switch (unit) {
    case LengthUnit::kPt:
      return kInch / 72;
    case LengthUnit::kPc:
      return kInch / 6;
    case LengthUnit::kMm:
      return kInch / 25.4;
    case LengthUnit::kCm:
      return kInch / 2.54;
    case LengthUnit::kIn:
      return kInch;
    default:
      return 1;
  }
}

}  // namespace

std::optional<LengthUnit> length_unit(std::string_view name) {
  const auto found = std::ranges::find_if(
      kUnitNames, [name](const UnitName& entry) { return equal_ignoring_case(entry.name, name); });
  if (found == std::end(kUnitNames)) return std::nullopt;
  return found->unit;
}

std::optional<Length> parse_length(std::string_view text) {
  Scanner scanner(trimmed(text));
  Length length;
  if (!take_length(scanner, length) || !scanner.at_end()) return std::nullopt;
  return length;
}

std::optional<Length> parse_leading_length(std::string_view text) {
  Scanner scanner(trimmed(text));
  Length length;
  if (!take_length(scanner, length)) return std::nullopt;
  return length;
}

std::optional<std::vector<Length>> parse_length_list(std::string_view text) {
  std::vector<Length> lengths;
  Scanner scanner(trimmed(text));
  bool comma = false;
  while (!scanner.at_end()) {
    Length length;
    if (!take_length(scanner, length)) return std::nullopt;
    lengths.push_back(length);
    comma = scanner.skip_separator();
  }
  if (comma) return std::nullopt;
  return lengths;
}

double resolve(Length length, LengthAxis axis, const LengthContext& context) {
  switch (length.unit) {
    case LengthUnit::kPercent:
      return length.value / 100 * percentage_base(axis, context);
    case LengthUnit::kEm:
      return length.value * context.font_size;
    case LengthUnit::kEx:
      return length.value * context.font_size / 2;
    default:
      return length.value * px_per_unit(length.unit);
  }
}

std::optional<double> parse_number(std::string_view text) {
  Scanner scanner(trimmed(text));
  double number = 0;
  if (!scanner.take_css_number(number) || !scanner.at_end()) return std::nullopt;
  return number;
}

std::optional<double> parse_opacity(std::string_view text) { return to_share(parse_length(text)); }

std::optional<double> parse_leading_opacity(std::string_view text) {
  return to_share(parse_leading_length(text));
}

}  // namespace libstyle::svg
