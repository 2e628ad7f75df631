// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/angle.h"

#include <cmath>
#include <numbers>

#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

// The sum of a Taylor series of sine (first = x, offset = 2) or cosine (first = 1, offset = 1) for
// |x| <= pi/4, where the first term left out is below 1e-17. The smallest terms are added first.
double taylor_sum(double first, double x, int offset) {
  constexpr int kTerms = 9;
  double terms[kTerms] = {first};
  for (int i = 1; i < kTerms; ++i) {
    const int factor = 2 * i + offset - 2;
    terms[i] = terms[i - 1] * -(x * x) / (factor * (factor + 1));
  }
  double sum = 0;
  for (int i = kTerms - 1; i >= 0; --i) sum += terms[i];
  return sum;
}

}  // namespace

Vector unit_vector_at(double degrees) {
  const double turned = std::remainder(degrees, 360.0);  // exact
  const double quarters = std::nearbyint(turned / 90);   // -2 .. 2
  const double rest = (turned - 90 * quarters) / 180 * std::numbers::pi;
  const double cosine = taylor_sum(1, rest, 1), sine = taylor_sum(rest, rest, 2);
  switch (static_cast<int>(quarters)) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case -1:
      return {sine, -cosine};
    default:
      return {-cosine, -sine};
  }
}

std::optional<double> degrees_per_svg_unit(std::string_view unit) {
  return equal_ignoring_case(unit, "turn") ? std::nullopt : degrees_per_unit(unit);
}

std::optional<double> degrees_per_unit(std::string_view unit) {
  if (equal_ignoring_case(unit, "deg")) return 1;
  if (equal_ignoring_case(unit, "grad")) return 0.9;
  if (equal_ignoring_case(unit, "rad")) return 180 / std::numbers::pi;
  if (equal_ignoring_case(unit, "turn")) return 360;
  return std::nullopt;
}

}  // namespace libstyle::svg
