// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/orientation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/curves.h"

namespace libstyle {
namespace {

// Points whose coordinates are multiples of 2^-40 below 8: products fit into 128 bits.
constexpr double kUnit = 1.0 / (1ll << 40);

__extension__ using Int128 = __int128;

int integer_orientation(Point a, Point b, Point c) {
  const auto integer = [](double value) { return static_cast<Int128>(value / kUnit); };
  const auto determinant = (integer(b.x) - integer(a.x)) * (integer(c.y) - integer(a.y)) -
                           (integer(b.y) - integer(a.y)) * (integer(c.x) - integer(a.x));
  return (determinant > 0) - (determinant < 0);
}

TEST(Orientation, IsClockwisePositiveOnThePage) {
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {1, 1}), 1);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {1, -1}), -1);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {7, 0}), 0);
}

TEST(Orientation, IsExactForPointsAllButInLine) {
  int zeros = 0;
  for_each_seed(20000, [&](std::uint64_t seed) {
    RandomValues random(seed);
    const auto coordinate = [&] { return std::round(random.uniform(0, 4) / kUnit) * kUnit; };
    const Point a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    // Near the line through a and b, a few units off.
    Point c = lerp(a, b, 0.25 * static_cast<double>(random.below(9)));
    c.x = std::round(c.x / kUnit + random.uniform(-1.4, 1.4)) * kUnit;
    c.y = std::round(c.y / kUnit + random.uniform(-1.4, 1.4)) * kUnit;
    const int expected = integer_orientation(a, b, c);
    zeros += expected == 0;
    ASSERT_EQ(orientation(a, b, c), expected);
    ASSERT_EQ(orientation(b, c, a), expected);
    ASSERT_EQ(orientation(b, a, c), -expected);
  });
  EXPECT_GT(zeros, 20);
}

}  // namespace
}  // namespace libstyle
