// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libstyle/base/random.h"

namespace libstyle::svg {
namespace {

TEST(Angle, QuarterTurnsAreExact) {
  EXPECT_EQ(unit_vector_at(0), (Vector{1, 0}));
  EXPECT_EQ(unit_vector_at(90), (Vector{0, 1}));
  EXPECT_EQ(unit_vector_at(-180), (Vector{-1, 0}));
  EXPECT_EQ(unit_vector_at(270 + 360 * 1000.0), (Vector{0, -1}));
}

TEST(Angle, AgreesWithSineAndCosine) {
  const RandomStream random(1, 0);
  for (std::uint64_t i = 0; i < 10000; ++i) {
    const double degrees = 360 * random.uniform(i) - 180;
    const Vector unit = unit_vector_at(degrees);
    const long double radians =
        static_cast<long double>(degrees) / 180 * std::numbers::pi_v<long double>;
    EXPECT_NEAR(unit.x, static_cast<double>(std::cos(radians)), 2.3e-16) << degrees;
    EXPECT_NEAR(unit.y, static_cast<double>(std::sin(radians)), 2.3e-16) << degrees;
  }
}

TEST(Angle, KnowsTheUnitsOfCss) {
  EXPECT_EQ(degrees_per_unit("deg"), 1);
  EXPECT_EQ(degrees_per_unit("TURN"), 360);
  EXPECT_EQ(100 * degrees_per_unit("grad").value(), 90);
  EXPECT_DOUBLE_EQ(std::numbers::pi * degrees_per_unit("rad").value(), 180);
  EXPECT_EQ(degrees_per_unit("px"), std::nullopt);
}

}  // namespace
}  // namespace libstyle::svg
