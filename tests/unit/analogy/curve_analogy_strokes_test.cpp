// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "tests/support/analogy_examples.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"
#include "tests/support/seeds.h"

namespace libstyle {
namespace {

// Strokes between these x along a line, at y, as the example of a line of 600 px.
ExamplePair strokes_pair(std::span<const std::array<double, 3>> strokes) {
  ExamplePair pair;
  pair.unfiltered = with_length_parameter(polyline("0 0, 600 0"));
  for (const auto& [begin, end, y] : strokes) {
    const SampledCurve stroke =
        with_length_parameter({{{begin, y}, {(begin + end) / 2, y}, {end, y}}, false});
    if (pair.filtered.size() == 0) {
      pair.filtered = stroke;
    } else {
      pair.others.push_back(stroke);
    }
  }
  return pair;
}

ExamplePair dashes() {
  std::vector<std::array<double, 3>> strokes;
  for (double x = 0; x < 590; x += 20) strokes.push_back({x, x + 12, 0});
  return strokes_pair(strokes);
}

// Three strokes over one another at heights of their own, without end.
ExamplePair rails() {
  return strokes_pair(std::vector<std::array<double, 3>>{{0, 600, 0}, {0, 600, 4}, {0, 600, -7}});
}

TEST(CurveAnalogy, DashesStayDashes) {
  const ExamplePair pair = dashes();
  const CurveAnalogy style({&pair, 1}, {});
  for_each_seed(10, [&](std::uint64_t seed) {
    const StyledCurve drawn = style.draw(polyline("0 0, 1006 0"), {seed});
    EXPECT_NEAR(static_cast<double>(drawn.strokes.size()), 50, 2);
    double sum = 0, last = 0;
    for (const DrawnLine& stroke : drawn.strokes) {
      EXPECT_GE(stroke.lengths.front(), last);
      sum += stroke.lengths.back() - stroke.lengths.front();
      last = stroke.lengths.back();
      for (const Point p : stroke.curve.points) EXPECT_NEAR(p.y, 0, 1e-6);
      EXPECT_NEAR(stroke.curve.points.back().x, stroke.lengths.back(), 1e-6);
    }
    EXPECT_NEAR(sum / 1006, 0.6, 0.02);
    // The ends of the line are there.
    EXPECT_EQ(drawn.strokes.front().curve.points.front(), (Point{0, 0}));
    EXPECT_EQ(drawn.strokes.back().curve.points.back(), (Point{1006, 0}));
  });
}

TEST(CurveAnalogy, StrokesOverOneAnotherStaySo) {
  const ExamplePair pair = rails();
  CurveAnalogyParameters parameters;
  parameters.keep_ends = false;
  const CurveAnalogy style({&pair, 1}, parameters);
  for_each_seed(10, [&](std::uint64_t seed) {
    const StyledCurve drawn = style.draw(polyline("0 0, 1500 0"), {seed});
    ASSERT_EQ(drawn.strokes.size(), 3u);
    std::vector<double> heights;
    for (const DrawnLine& stroke : drawn.strokes) {
      heights.push_back(stroke.curve.points.front().y);
      EXPECT_EQ(stroke.lengths.front(), 0);
      EXPECT_EQ(stroke.lengths.back(), 1500);
      for (const Point p : stroke.curve.points) EXPECT_NEAR(p.y, heights.back(), 1e-6);
    }
    EXPECT_THAT(heights, testing::UnorderedElementsAre(testing::DoubleNear(0, 1e-6),
                                                       testing::DoubleNear(4, 1e-6),
                                                       testing::DoubleNear(-7, 1e-6)));
  });
}

TEST(CurveAnalogy, OfSeveralStrokesTheNearestKeepsTheEnds) {
  const StyledCurve drawn = draw_by_analogy(rails(), polyline("0 0, 1500 0"));
  for (const DrawnLine& stroke : drawn.strokes) {
    const double middle = stroke.curve.points[stroke.curve.points.size() / 2].y;
    EXPECT_NEAR(stroke.curve.points.front().y, middle, 1e-6);
    if (std::abs(middle) < 1) {
      EXPECT_EQ(stroke.curve.points.front(), (Point{0, 0}));
    }
  }
}

double nearest_stroke(const StyledCurve& drawn, Point place) {
  double least = HUGE_VAL;
  for (const DrawnLine& stroke : drawn.strokes) {
    least = std::min(least, distance_from(stroke.curve, place));
  }
  return least;
}

TEST(CurveAnalogy, OfSeveralStrokesOneMeetsEachConstraint) {
  const ExamplePair pair = rails();
  const CurveAnalogy style({&pair, 1}, {});
  const ArcLength along(s_curve());
  for_each_seed(20, [&](std::uint64_t seed) {
    RandomValues random(seed);
    std::vector<CurveConstraint> constraints;
    for (const double t : {random.uniform(0.1, 0.45), random.uniform(0.55, 0.9)}) {
      const Vector off = {random.normal(15), random.normal(15)};
      constraints.push_back({t, along.point_at(t * along.total()) + off, {}});
    }
    const StyledCurve drawn = style.draw(s_curve(), {seed, {}, 0, constraints});
    EXPECT_EQ(drawn.strokes.size(), 3U);
    for (const CurveConstraint& constraint : constraints) {
      EXPECT_LT(nearest_stroke(drawn, constraint.position), 1e-9);
    }
  });
}

TEST(CurveAnalogy, StrokesGoRoundClosedLines) {
  const ExamplePair pair = rails();
  const StyledCurve drawn = draw_by_analogy(pair, circle({0, 0}, 200, 300));
  ASSERT_EQ(drawn.strokes.size(), 3u);
  for (const DrawnLine& stroke : drawn.strokes) EXPECT_TRUE(stroke.curve.closed);

  // A round line that 64 dashes fit on: none of them begins or ends on the seam but by chance.
  const ExamplePair broken = dashes();
  const CurveAnalogy style({&broken, 1}, {});
  const double length = 64 * 20;
  const Polyline round = circle({0, 0}, 200 * length / arc_length(circle({0, 0}, 200, 300)), 300);
  std::size_t passing = 0;
  for (std::uint64_t place = 0; place < 20; ++place) {
    const StyledCurve dashed = style.draw(round, {place});
    EXPECT_EQ(dashed.strokes.size(), 64u);
    for (const DrawnLine& stroke : dashed.strokes) {
      EXPECT_NEAR(stroke.lengths.back() - stroke.lengths.front(), 12, 0.5);
      passing += stroke.lengths.back() > length + 1e-6;
    }
  }
  EXPECT_GT(passing, 5u);
}

TEST(CurveAnalogy, TheGreedySearchRefusesStrokes) {
  const ExamplePair pair = dashes();
  CurveAnalogyParameters parameters;
  parameters.method = AnalogyMethod::kGreedy;
  EXPECT_THROW(CurveAnalogy({&pair, 1}, parameters), Error);
}

}  // namespace
}  // namespace libstyle
