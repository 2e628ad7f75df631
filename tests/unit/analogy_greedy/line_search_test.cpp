// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/geometry/arc_length.h"
#include "tests/support/matchers.h"
#include "tests/unit/analogy_greedy/curves.h"

namespace libstyle {
namespace {

CurveAnalogyParameters greedy() {
  CurveAnalogyParameters p;
  p.method = AnalogyMethod::kGreedy;
  p.samples = 200;
  p.search.passes = 1;
  p.search.coarsest_samples = 60;
  return p;
}

ExamplePair example() { return {straight(160), wave(160, 16, 3), true}; }

TEST(LineSearch, KeepsEndsAndCornersExactly) {
  const Polyline corner = polyline("3 4, 90 10, 80 110.7");
  const StyledCurve drawn = draw_by_analogy(example(), corner, greedy());
  EXPECT_EQ(drawn.curve.points.front(), corner.points[0]);
  EXPECT_EQ(drawn.curve.points.back(), corner.points[2]);
  ASSERT_EQ(drawn.corners.size(), 1);
  EXPECT_EQ(drawn.curve.points[drawn.corners[0]], corner.points[1]);
}

TEST(LineSearch, PassesThroughHeldPlaces) {
  const ExamplePair pair = example();
  const CurveAnalogy style({&pair, 1}, greedy());
  const double held[] = {40};
  const StyledCurve drawn = style.draw(polyline("0 0, 100 0"), {.held = held});
  EXPECT_THAT(drawn.curve.points, testing::Contains(PointNear({40, 0}, 1e-9)));
}

TEST(LineSearch, LetsLooseEndsGo) {
  CurveAnalogyParameters p = greedy();
  p.keep_ends = false;
  const ExamplePair pair{straight(160), moved(wave(160, 16, 3), {0, 9}), true};
  const StyledCurve drawn = draw_by_analogy(pair, polyline("0 0, 100 0"), p);
  EXPECT_NEAR(drawn.curve.points.front().y, 9, 5);
  EXPECT_NEAR(drawn.curve.points.back().y, 9, 5);
}

TEST(LineSearch, GivesShortLinesTheStyleSmaller) {
  const StyledCurve drawn = draw_by_analogy(example(), polyline("0 0, 12 0"), greedy());
  EXPECT_LT(drawn.mean_scale, 1);
  double highest = 0;
  for (const Point p : drawn.curve.points) highest = std::max(highest, std::abs(p.y));
  EXPECT_LT(highest, 3);
  EXPECT_GT(highest, 0);
}

TEST(LineSearch, TellsLengthsAndRunsAlongTheWholeLine) {
  const ExamplePair pair = example();
  const CurveAnalogy style({&pair, 1}, greedy());
  const StyledCurve drawn = style.draw(polyline("0 0, 100 0"), {});
  ASSERT_EQ(drawn.lengths.size(), drawn.curve.points.size());
  EXPECT_EQ(drawn.lengths.front(), 0);
  EXPECT_EQ(drawn.lengths.back(), 100);
  EXPECT_TRUE(std::ranges::is_sorted(drawn.lengths));
  std::size_t steps = 0;
  for (const ChainRun& run : drawn.runs) {
    EXPECT_EQ(run.first, steps);
    EXPECT_GT(run.steps, 0);
    EXPECT_LE(run.origin + run.steps, style.example().state_count());
    steps += run.steps;
  }
  EXPECT_NEAR(static_cast<double>(steps) * style.example().step(), 100, 30);
}

TEST(LineSearch, DrawsClosedCurvesClosed) {
  const StyledCurve drawn = draw_by_analogy(example(), circle({}, 25, 100), greedy());
  EXPECT_TRUE(drawn.curve.closed);
  EXPECT_GT(arc_length(drawn.curve), 2 * std::numbers::pi * 25);
}

TEST(LineSearch, IsAnotherMethodThanTheChain) {
  CurveAnalogyParameters p = greedy();
  const Polyline line = polyline("0 0, 100 0");
  const StyledCurve searched = draw_by_analogy(example(), line, p);
  p.method = AnalogyMethod::kChain;
  EXPECT_NE(searched.curve, draw_by_analogy(example(), line, p).curve);
  p.method = AnalogyMethod::kGreedy;
  p.search = paper_parameters();
  p.search.finest_spacing.reset();
  p.search.levels = 2;
  p.search.neighborhood_samples = 41;
  EXPECT_NE(searched.curve, draw_by_analogy(example(), line, p).curve);
}

}  // namespace
}  // namespace libstyle
