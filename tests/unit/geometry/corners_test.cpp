// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/corners.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "libstyle/base/error.h"
#include "libstyle/geometry/sampled_curve.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(FindCorners, SeesEveryCornerOfABarePolygon) {
  EXPECT_THAT(find_corners(polyline("0 0, 50 0, 50 50, 0 50 z")), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(find_corners(polyline("0 0, 50 0, 50 50, 0 50")), ElementsAre(1, 2));
  EXPECT_THAT(find_corners(polyline("0 0, 50 0, 20 1")), ElementsAre(1));
}

TEST(FindCorners, TakesTheAngleAsTheLeastTurn) {
  for (double degrees = 5; degrees < 180; degrees += 10) {
    const double turn = degrees * std::numbers::pi / 180;
    const Polyline bend{{{-9, 0}, {0, 0}, {9 * std::cos(turn), 9 * std::sin(turn)}}, false};
    const Polyline even = resample(bend, 0.5);
    EXPECT_THAT(find_corners(even, {.angle = turn - 0.01}), SizeIs(1)) << degrees;
    EXPECT_THAT(find_corners(even, {.angle = turn + 0.01}), IsEmpty()) << degrees;
  }
}

TEST(FindCorners, SeesNoneOnSmoothCurvesEvenTightOnes) {
  for (const double radius : {1.3, 2.0, 5.0, 50.0}) {
    EXPECT_THAT(find_corners(circle({}, radius, 200)), IsEmpty()) << radius;
  }
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    ASSERT_THAT(find_corners(random_blob(random, 300)), IsEmpty());
  });
}

TEST(FindCorners, IsNotFooledByNoise) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    const Polyline square = resample(polyline("0 0, 40 0, 40 40, 0 40 z"), 0.5);
    const Polyline shaky = with_noise(square, random, 0.06);
    const std::vector<std::size_t> corners = find_corners(shaky);
    ASSERT_THAT(corners, SizeIs(4));
    for (const std::size_t corner : corners) {
      const Point p = shaky.points[corner];
      const Point nearest{std::round(p.x / 40) * 40, std::round(p.y / 40) * 40};
      ASSERT_THAT(p, PointNear(nearest, 1.0));
    }
    ASSERT_THAT(find_corners(with_noise(circle({}, 20, 250), random, 0.12)), IsEmpty());
  });
}

TEST(FindCorners, PassesOverRepeatedPoints) {
  EXPECT_THAT(find_corners(polyline("0 0, 9 0, 9 0, 9 0, 9 9, 9 9")), ElementsAre(1));
  EXPECT_THAT(find_corners(polyline("5 5, 5 5, 5 5 z")), IsEmpty());
  EXPECT_THAT(find_corners(polyline("5 5, 6 5")), IsEmpty());
}

TEST(FindCorners, ChecksItsParametersAndPoints) {
  EXPECT_THROW(find_corners(polyline("0 0, 1 1"), {.angle = 4}), Error);
  EXPECT_THROW(find_corners(polyline("0 0, 1 1"), {.reach = 0}), Error);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(find_corners({{{0, 0}, {nan, 0}, {1, 1}}, false}), Error);
}

}  // namespace
}  // namespace libstyle
