// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/bezier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libstyle/geometry/arc_length.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

CubicBezier random_cubic(RandomValues& random) {
  const Polyline points = random_scribble(random, 4, 10);
  return {points.points[0], points.points[1], points.points[2], points.points[3]};
}

// The usual cubic for a quarter of the unit circle; its radius errs by 2.7e-4 at most.
CubicBezier quarter_circle() {
  const double k = 4.0 / 3 * (std::numbers::sqrt2 - 1);
  return {{1, 0}, {1, k}, {k, 1}, {0, 1}};
}

TEST(Bezier, EndsAreExact) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    const CubicBezier curve = random_cubic(random);
    ASSERT_EQ(point_at(curve, 0), curve.p0);
    ASSERT_EQ(point_at(curve, 1), curve.p3);
    const auto [before, after] = split_at(curve, random.uniform(0, 1));
    ASSERT_EQ(before.p0, curve.p0);
    ASSERT_EQ(before.p3, after.p0);
    ASSERT_EQ(after.p3, curve.p3);
  });
}

TEST(Bezier, EqualsItsBernsteinForm) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    const CubicBezier c = random_cubic(random);
    const double t = random.uniform(0, 1), s = 1 - t;
    const Point expected =
        s * s * s * c.p0 + 3 * s * s * t * c.p1 + 3 * s * t * t * c.p2 + t * t * t * c.p3;
    ASSERT_THAT(point_at(c, t), PointNear(expected, 1e-13));
  });
}

TEST(Bezier, DerivativesAreLimitsOfDifferences) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    const CubicBezier c = random_cubic(random);
    const double t = random.uniform(0.1, 0.9), h = 1e-4;
    const Vector slope = (point_at(c, t + h) - point_at(c, t - h)) / (2 * h);
    const Vector bend = (derivative_at(c, t + h) - derivative_at(c, t - h)) / (2 * h);
    ASSERT_THAT(derivative_at(c, t), PointNear(slope, 1e-5));
    ASSERT_THAT(second_derivative_at(c, t), PointNear(bend, 1e-5));
    ASSERT_THAT(tangent_at(c, t), PointNear(normalized(slope), 1e-4));
  });
}

TEST(Bezier, PiecesFollowTheCurve) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    const CubicBezier c = random_cubic(random);
    const double t0 = random.uniform(0, 0.5), t1 = random.uniform(0.5, 1);
    const CubicBezier piece = piece_between(c, t0, t1);
    const auto [before, after] = split_at(c, t0);
    for (const double u : {0.0, 0.3, 0.9, 1.0}) {
      ASSERT_THAT(point_at(piece, u), PointNear(point_at(c, t0 + u * (t1 - t0)), 1e-12));
      ASSERT_THAT(point_at(before, u), PointNear(point_at(c, u * t0), 1e-12));
      ASSERT_THAT(point_at(after, u), PointNear(point_at(c, t0 + u * (1 - t0)), 1e-12));
      ASSERT_THAT(point_at(reversed(c), u), PointNear(point_at(c, 1 - u), 1e-12));
    }
  });
}

TEST(Bezier, TangentsAtEndsLookPastControlsThatCoincide) {
  const Vector right{1, 0}, down{0, 1};
  EXPECT_EQ(tangent_at({{0, 0}, {0, 0}, {2, 0}, {2, 2}}, 0), right);
  EXPECT_EQ(tangent_at({{0, 0}, {0, 0}, {0, 0}, {2, 0}}, 0), right);
  EXPECT_EQ(tangent_at({{0, 0}, {2, 0}, {2, 2}, {2, 2}}, 1), down);
  EXPECT_EQ(tangent_at({{0, 0}, {2, 2}, {2, 2}, {2, 2}}, 1), normalized({1, 1}));
  EXPECT_EQ(tangent_at({{3, 3}, {3, 3}, {3, 3}, {3, 3}}, 0.5), Vector{});
}

TEST(Bezier, CurvatureOfACircleIsOneOverTheRadiusWithItsSign) {
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    EXPECT_NEAR(curvature_at(quarter_circle(), t), 1, 0.022);
    EXPECT_NEAR(curvature_at(reversed(quarter_circle()), t), -1, 0.022);
  }
}

TEST(Bezier, BoxIsTight) {
  for_each_seed(100, [](std::uint64_t seed) {
    RandomValues random(seed);
    const CubicBezier c = random_cubic(random);
    const Box box = bounding_box(c);
    Box sampled;
    for (int i = 0; i <= 2000; ++i) sampled.include(point_at(c, i / 2000.0));
    ASSERT_THAT(box.low, PointNear(sampled.low, 1e-4));
    ASSERT_THAT(box.high, PointNear(sampled.high, 1e-4));
    Box both = box;
    both.include(sampled);
    ASSERT_THAT(both.low, PointNear(box.low, 1e-13));
    ASSERT_THAT(both.high, PointNear(box.high, 1e-13));
  });
}

TEST(Bezier, BoxOfAStraightSegmentIsThatOfItsEnds) {
  const Box box = bounding_box(straight_bezier({3, 1}, {0, 2}));
  EXPECT_EQ(box.low, (Point{0, 1}));
  EXPECT_EQ(box.high, (Point{3, 2}));
}

TEST(Bezier, LengthIsWithinItsTolerance) {
  EXPECT_NEAR(arc_length(straight_bezier({0, 0}, {3, 4})), 5, 1e-12);
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    CubicBezier c = random_cubic(random);
    if (seed % 5 == 0) c.p3 = c.p0 + (c.p2 - c.p1) + Vector{1e-3, 0};  // all but a cusp
    double sampled = 0;
    for (int i = 0; i < 100000; ++i) {
      sampled += distance(point_at(c, i / 1e5), point_at(c, (i + 1) / 1e5));
    }
    ASSERT_NEAR(arc_length(c, 1e-3), sampled, 1e-3);
    ASSERT_NEAR(arc_length(c, 1e-7), sampled, 2e-7);
  });
}

// B(t) = (t^2, t^3) has its cusp at 0 and the length (13 sqrt(13) - 8) / 27.
TEST(Bezier, LengthOfACuspIsRight) {
  const CubicBezier cusp{{0, 0}, {0, 0}, {1.0 / 3, 0}, {1, 1}};
  EXPECT_NEAR(arc_length(cusp, 1e-9), (13 * std::sqrt(13.0) - 8) / 27, 1e-9);
}

}  // namespace
}  // namespace libstyle
