// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/plain_lines.h"

#include <gmock/gmock.h>

#include <numbers>

#include "libstyle/geometry/arc_length.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

constexpr double kFortyDegrees = 40 * std::numbers::pi / 180;

TEST(PlainLines, ARectangleIsItsFourSides) {
  const auto lines = split_into_lines(polyline("0 0, 100 0, 100 50, 0 50 z"), kFortyDegrees, 10);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].line, polyline("0 0, 100 0"));
  EXPECT_EQ(lines[1].line, polyline("100 0, 100 50"));
  EXPECT_EQ(lines[3].line, polyline("0 50, 0 0"));
  EXPECT_EQ(lines[2].length_before, 150);
  for (const PlainLine& line : lines) EXPECT_TRUE(line.starts_at_corner);
}

TEST(PlainLines, ACircleHasNoCorner) {
  for (const double radius : {1.0, 10.0, 100.0}) {
    const Polyline curve = circle({0, 0}, radius, 90);
    const auto lines = split_into_lines(curve, kFortyDegrees, 10);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].line, curve);
  }
}

TEST(PlainLines, SerifsAsSmallAsTheReachKeepTheirCorners) {
  // A stem with a foot of 4 px under a style that looks at 5 px to each side.
  const Polyline curve = polyline("0 0, 8 0, 8 60, 12 60, 12 64, -4 64, -4 60, 0 60 z");
  EXPECT_EQ(split_into_lines(curve, kFortyDegrees, 5).size(), 8u);
}

TEST(PlainLines, TheTrembleOfAHandMakesNoCorners) {
  RandomValues random(4);
  Polyline curve;
  for (int x = 0; x <= 300; ++x) curve.points.push_back({1.0 * x, random.normal(0.3)});
  EXPECT_EQ(split_into_lines(curve, kFortyDegrees, 20).size(), 1u);
}

TEST(PlainLines, LinesCoverTheCurveInOrder) {
  for_each_seed(30, [](std::uint64_t seed) {
    RandomValues random(seed);
    Polyline curve = random_scribble(random, 12, 100);
    curve.closed = random.chance(0.5);
    double total = 0;
    Point last;
    const auto lines = split_into_lines(curve, kFortyDegrees, 5);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i > 0) {
        EXPECT_EQ(lines[i].line.points.front(), last);
      }
      EXPECT_NEAR(lines[i].length_before - lines[0].length_before, total, 1e-9);
      total += arc_length(lines[i].line);
      last = lines[i].line.points.back();
    }
    EXPECT_NEAR(total, arc_length(curve), 1e-9);
    if (curve.closed && lines.size() > 1) {
      EXPECT_EQ(last, lines[0].line.points.front());
    }
  });
}

TEST(PlainLines, ACurveWithoutLengthHasNone) {
  EXPECT_TRUE(split_into_lines(polyline("3 4"), kFortyDegrees, 5).empty());
  EXPECT_TRUE(split_into_lines(polyline("3 4, 3 4, 3 4"), kFortyDegrees, 5).empty());
  EXPECT_TRUE(split_into_lines({}, kFortyDegrees, 5).empty());
}

}  // namespace
}  // namespace libstyle
