// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/cairo/drawing.h"

namespace libstyle {
namespace {

PathRecord dashed(PathRecord record, std::vector<double> dashes, double offset = 0) {
  record.style.dash_array = std::move(dashes);
  record.style.dash_offset = offset;
  return record;
}

TEST(DrawStroke, SubpathsWithoutLengthAreDotsUnderRoundAndSquareCaps) {
  for (const char* dot : {"M50 50 L50 50", "M50 50 Z", "M50 50 C50 50 50 50 50 50"}) {
    PathRecord record = stroked(dot, 20);
    EXPECT_EQ(covered_area(draw(make_page({record}))), 0) << dot;
    record.style.line_cap = LineCap::kRound;
    EXPECT_NEAR(covered_area(draw(make_page({record}))), 314, 3) << dot;
    record.style.line_cap = LineCap::kSquare;
    EXPECT_NEAR(covered_area(draw(make_page({record}))), 400, 1) << dot;
  }
}

TEST(DrawStroke, AMoveAloneIsNoDot) {
  PathRecord record = stroked("M50 50 M20 20", 20);
  for (const LineCap cap : {LineCap::kButt, LineCap::kRound, LineCap::kSquare}) {
    record.style.line_cap = cap;
    EXPECT_EQ(covered_area(draw(make_page({record}))), 0);
  }
}

TEST(DrawStroke, SquareDotsFollowThePen) {
  PathRecord record = stroked("M50 50 L50 50", 10);
  record.style.line_cap = LineCap::kSquare;
  record.style.stroke_transform = Transform::scaling(4, 1);
  EXPECT_EQ(count_different(draw(make_page({record})),
                            draw(make_page({filled("M30 45 L70 45 L70 55 L30 55 Z")})), 16),
            0u);
}

TEST(DrawStroke, APenHasTheWidthsOfItsTransform) {
  PathRecord record = stroked("M50 0 L50 100 M0 50 L100 50", 10);
  record.style.stroke_transform = Transform::scaling(3, 0.5);
  const Raster image = draw(make_page({record}));
  EXPECT_NEAR(covered_area(image), 30 * 100 + 5 * 100 - 30 * 5, 1);
}

TEST(DrawStroke, APenFlattenedToALineDrawsNothing) {
  PathRecord record = stroked("M50 0 L50 100", 10);
  record.style.stroke_transform = Transform::scaling(1, 0);
  EXPECT_EQ(covered_area(draw(make_page({record}))), 0);
}

TEST(DrawStroke, DashesThatAreNoneDrawSolid) {
  const PathRecord solid = stroked("M10 50 L90 50", 4);
  const Raster expected = draw(make_page({solid}));
  EXPECT_EQ(draw(make_page({dashed(solid, {0, 0})})), expected);
  EXPECT_EQ(draw(make_page({dashed(solid, {5, -1})})), expected);
}

TEST(DrawStroke, OddDashArraysRunTwice) {
  const PathRecord line = stroked("M10 50 L90 50", 4);
  EXPECT_EQ(draw(make_page({dashed(line, {3, 5, 7}, 2)})),
            draw(make_page({dashed(line, {3, 5, 7, 3, 5, 7}, 2)})));
}

TEST(DrawStroke, DashOffsetsRepeatWithThePattern) {
  const PathRecord line = stroked("M10 50 L90 50", 4);
  const Raster expected = draw(make_page({dashed(line, {4, 6}, 3)}));
  EXPECT_EQ(draw(make_page({dashed(line, {4, 6}, 3 - 70)})), expected);
  EXPECT_EQ(draw(make_page({dashed(line, {4, 6}, 3 + 1e9)})), expected);
}

// A line that begins far outside is cut, its dashes are not moved.
TEST(DrawStroke, CuttingKeepsThePhaseOfDashes) {
  const Raster near = draw(make_page({dashed(stroked("M-100 50 L200 50", 4), {7, 6})}));
  const Raster far = draw(make_page({dashed(stroked("M-1300100 50 L200 50", 4), {7, 6})}));
  EXPECT_EQ(count_different(near, far, 8), 0u);
}

TEST(DrawStroke, MoreDashesThanCanBeSeenAreATint) {
  const PathRecord line = dashed(stroked("M0 50 L100 50", 100), {1e-5, 3e-5});
  EXPECT_NEAR(draw(make_page({line})).at(50, 50)[3], 64, 2);
}

}  // namespace
}  // namespace libstyle
