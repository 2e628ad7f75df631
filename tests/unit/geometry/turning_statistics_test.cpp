// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/turning_statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libstyle/base/error.h"
#include "libstyle/geometry/rigid_alignment.h"
#include "tests/support/curves.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

TEST(WassersteinDistance, IsTheMeanDifferenceOfQuantiles) {
  EXPECT_EQ(wasserstein_distance({1, 2, 3}, {3, 2, 1}), 0);
  EXPECT_EQ(wasserstein_distance({0, 1}, {5, 6}), 5);
  EXPECT_EQ(wasserstein_distance({0}, {0, 0, 3}), 1);
  // Quantiles of {0, 6} and {0, 3, 6}: 0 | 3 | 3 | 0 over sixths 2, 1, 1, 2.
  EXPECT_EQ(wasserstein_distance({0, 6}, {0, 3, 6}), 1);
}

TEST(WassersteinDistance, AgreesWithTheAreaBetweenDistributions) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    std::vector<double> a, b;
    for (std::size_t i = 0; i < 1 + seed % 17; ++i) a.push_back(random.uniform(0, 1));
    for (std::size_t i = 0; i < 1 + seed % 23; ++i) b.push_back(random.uniform(0, 1));
    const auto below = [](const std::vector<double>& values, double x) {
      return static_cast<double>(std::ranges::count_if(values, [&](double v) { return v < x; })) /
             static_cast<double>(values.size());
    };
    double area = 0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      const double x = (i + 0.5) / kSteps;
      area += std::abs(below(a, x) - below(b, x)) / kSteps;
    }
    ASSERT_NEAR(wasserstein_distance(a, b), area, 5e-3);
    ASSERT_EQ(wasserstein_distance(a, b), wasserstein_distance(b, a));
  });
}

TEST(TurningAngles, OfARegularPolygonAreAllTheSame) {
  for (const std::size_t step : {1, 2, 5}) {
    const std::vector<double> angles = turning_angles(circle({}, 3, 36), step);
    ASSERT_THAT(angles, SizeIs(36));
    for (const double angle : angles) {
      EXPECT_NEAR(angle, static_cast<double>(step) * std::numbers::pi / 18, 1e-12);
    }
  }
}

TEST(TurningAngles, OfAnOpenCurveLeaveTheEndsOut) {
  EXPECT_THAT(turning_angles(polyline("0 0, 1 0, 2 0, 2 1"), 1),
              ElementsAre(0, std::numbers::pi / 2));
  EXPECT_THAT(turning_angles(polyline("0 0, 1 0, 2 0, 2 1"), 2), SizeIs(0));
}

TEST(TurningDistance, ForgetsPositionDirectionAndOrder) {
  RandomValues random(4);
  const Polyline stroke = random_stroke(random, 300);
  Polyline moved = stroke;
  for (Point& p : moved.points) p = rotation_between({1, 0}, {0.6, 0.8}, {5, 5})(p);
  EXPECT_NEAR(turning_distance(stroke, moved, 1), 0, 1e-9);
}

TEST(TurningDistance, TellsStylesApart) {
  RandomValues random(5);
  const Polyline calm = random_stroke(random, 5000), other_calm = random_stroke(random, 5000);
  const Polyline shaky = with_noise(random_stroke(random, 5000), random, 0.4);
  EXPECT_LT(turning_distance(calm, other_calm, 1), 0.1);
  EXPECT_GT(turning_distance(calm, shaky, 1), 0.2);
}

TEST(TurningDistance, RefusesCurvesTooShortForItsScales) {
  EXPECT_THROW(turning_distance(polyline("0 0, 3 0"), polyline("0 0, 99 0"), 1), Error);
}

}  // namespace
}  // namespace libstyle
