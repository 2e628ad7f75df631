// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/correspondence.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "libstyle/geometry/arc_length.h"
#include "tests/support/curves.h"

namespace libstyle {
namespace {

// A straight line that is busy in its first half only: there it is much longer.
Polyline half_busy_wave() {
  Polyline result;
  for (int i = 0; i <= 2000; ++i) {
    const double x = 0.1 * i;
    const double amplitude = x < 100 ? 4 : 0;
    result.points.push_back({x, amplitude * std::sin(2 * std::numbers::pi * x / 10)});
  }
  return result;
}

TEST(Correspondence, RisesFromEndToEnd) {
  for_each_seed(10, [](std::uint64_t seed) {
    RandomValues random(seed);
    const Polyline plain = random_stroke(random, 200);
    const Polyline filtered = with_noise(plain, random, 2);
    const std::vector<double> lengths = corresponding_lengths(filtered, plain);
    ASSERT_EQ(lengths.size(), filtered.points.size());
    EXPECT_NEAR(lengths.front(), 0, 1e-9);
    EXPECT_NEAR(lengths.back(), arc_length(plain), 1e-9 * arc_length(plain));
    EXPECT_TRUE(std::ranges::is_sorted(lengths));
  });
}

TEST(Correspondence, FollowsShapeNotLength) {
  const Polyline filtered = half_busy_wave();
  const std::vector<double> lengths = corresponding_lengths(filtered, polyline("0 0, 200 0"));
  for (std::size_t i = 0; i < lengths.size(); i += 50) {
    EXPECT_NEAR(lengths[i], filtered.points[i].x, 6);  // by arc length: off by up to 40
  }
}

TEST(Correspondence, DoesNotDependOnWhereTheCurvesLie) {
  Polyline filtered = half_busy_wave();
  const Polyline plain = polyline("0 0, 200 0");
  const std::vector<double> lengths = corresponding_lengths(filtered, plain);
  for (Point& p : filtered.points) p += {70, -30};
  const std::vector<double> moved = corresponding_lengths(filtered, plain);
  for (std::size_t i = 0; i < lengths.size(); ++i) EXPECT_NEAR(moved[i], lengths[i], 1e-6);
}

}  // namespace
}  // namespace libstyle
