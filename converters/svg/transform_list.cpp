// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/transform_list.h"

#include <algorithm>
#include <array>
#include <span>

#include "converters/svg/angle.h"
#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

enum class Argument : std::uint8_t { kNumber, kLength, kAngle };

// Builds a map from as many arguments as were given.
using Builder = Transform (*)(std::span<const double> arguments);

struct Function {
  std::string_view name;
  bool in_attribute;  // else in CSS only
  Argument first;     // the kind of all arguments but those of rotate about a point
  std::size_t least, most;
  Builder build;
};

double tangent(double degrees) {
  const Vector direction = unit_vector_at(degrees);
  return direction.y / direction.x;
}

double second_or(std::span<const double> arguments, double fallback) {
  return arguments.size() > 1 ? arguments[1] : fallback;
}

Transform rotation(std::span<const double> arguments) {
  const Vector axis = unit_vector_at(arguments[0]);
  const Transform turn = {axis.x, axis.y, -axis.y, axis.x, 0, 0};
  if (arguments.size() < 3) return turn;
  const Point center = {arguments[1], arguments[2]};
  return Transform::translation(center) * turn * Transform::translation(-center);
}

constexpr Function kFunctions[] = {
    {"matrix", true, Argument::kNumber, 6, 6,
     [](std::span<const double> a) { return Transform{a[0], a[1], a[2], a[3], a[4], a[5]}; }},
    {"translate", true, Argument::kLength, 1, 2,
     [](std::span<const double> a) { return Transform{1, 0, 0, 1, a[0], second_or(a, 0)}; }},
    {"translateX", false, Argument::kLength, 1, 1,
     [](std::span<const double> a) { return Transform{1, 0, 0, 1, a[0], 0}; }},
    {"translateY", false, Argument::kLength, 1, 1,
     [](std::span<const double> a) { return Transform{1, 0, 0, 1, 0, a[0]}; }},
    {"scale", true, Argument::kNumber, 1, 2,
     [](std::span<const double> a) { return Transform{a[0], 0, 0, second_or(a, a[0]), 0, 0}; }},
    {"scaleX", false, Argument::kNumber, 1, 1,
     [](std::span<const double> a) { return Transform{a[0], 0, 0, 1, 0, 0}; }},
    {"scaleY", false, Argument::kNumber, 1, 1,
     [](std::span<const double> a) { return Transform{1, 0, 0, a[0], 0, 0}; }},
    {"rotate", true, Argument::kAngle, 1, 3, rotation},
    {"skew", false, Argument::kAngle, 1, 2,
     [](std::span<const double> a) {
       return Transform{1, tangent(second_or(a, 0)), tangent(a[0]), 1, 0, 0};
     }},
    {"skewX", true, Argument::kAngle, 1, 1,
     [](std::span<const double> a) { return Transform{1, 0, tangent(a[0]), 1, 0, 0}; }},
    {"skewY", true, Argument::kAngle, 1, 1,
     [](std::span<const double> a) { return Transform{1, tangent(a[0]), 0, 1, 0, 0}; }},
};

class TransformParser {
 public:
  TransformParser(std::string_view text, bool css) : scanner_(trimmed(text)), css_(css) {}

  std::optional<Transform> parse() {
    Transform result;
    while (!scanner_.at_end()) {
      Transform next;
      if (!take_function(next)) return std::nullopt;
      result = result * next;
      if (css_) {
        scanner_.skip_spaces();
      } else {
        scanner_.skip_separator();
      }
    }
    if (!result.is_finite()) return std::nullopt;
    return result;
  }

 private:
  bool take_function(Transform& result) {
    const std::string_view name = scanner_.take_word();
    const auto function = std::ranges::find(kFunctions, name, &Function::name);
    if (function == std::end(kFunctions) || !(css_ || function->in_attribute)) return false;
    if (!css_) scanner_.skip_spaces();
    if (!scanner_.take('(')) return false;
    std::array<double, 6> arguments{};
    std::size_t count = 0;
    if (!take_arguments(*function, arguments, count)) return false;
    const bool rotates_about_point = function->build == rotation && count > 1;
    if (rotates_about_point && (css_ || count != 3)) return false;
    result = function->build(std::span(arguments).first(count));
    return true;
  }

  bool take_arguments(const Function& function, std::span<double> arguments, std::size_t& count) {
    scanner_.skip_spaces();
    do {
      if (count == function.most || !take_argument(function.first, arguments[count++]))
        return false;
    } while (take_separator());
    const bool closed = scanner_.take(')') || scanner_.at_end();  // CSS closes what is left open
    return closed && count >= function.least;
  }

  // Whether another argument must follow.
  bool take_separator() {
    const bool comma = scanner_.skip_separator();
    return comma || (!css_ && scanner_.peek() != ')' && !scanner_.at_end());
  }

  bool take_argument(Argument kind, double& value) {
    if (!scanner_.take_css_number(value)) return false;
    if (!css_) return true;
    if (scanner_.peek() == '%') return false;
    const std::string_view unit = scanner_.take_word();
    if (unit.empty()) return true;
    if (kind == Argument::kLength) return equal_ignoring_case(unit, "px");  // as in librsvg
    return kind == Argument::kAngle && scale_angle(unit, value);
  }

  static bool scale_angle(std::string_view unit, double& value) {
    const std::optional<double> degrees = degrees_per_svg_unit(unit);
    if (!degrees) return false;
    value *= *degrees;
    return true;
  }

  Scanner scanner_;
  bool css_;
};

}  // namespace

std::optional<Transform> parse_transform_attribute(std::string_view text) {
  return TransformParser(text, false).parse();
}

std::optional<Transform> parse_transform_property(std::string_view text) {
  if (trimmed(text) == "none") return Transform{};
  return TransformParser(text, true).parse();
}

}  // namespace libstyle::svg
