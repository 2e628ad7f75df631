// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/turning_statistics.h"
#include "tests/support/analogy_examples.h"
#include "tests/support/curves.h"

namespace libstyle {
namespace {

StyledCurve next_frame(const CurveAnalogy& style, const Polyline& line, const StyledCurve& before,
                       std::uint64_t frame, double coherence) {
  return style.draw(
      line,
      {.place = 3, .held = {}, .variant = frame, .before = &before.walks, .coherence = coherence});
}

TEST(CurveAnalogy, FramesStayOrAreDrawnAfresh) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  for (const Polyline& line : {s_curve(), egg()}) {
    const StyledCurve first = style.draw(line, {3});
    EXPECT_EQ(next_frame(style, line, first, 1, 1).curve, first.curve);
    EXPECT_EQ(next_frame(style, line, first, 1, 0).curve,
              style.draw(line, {.place = 3, .held = {}, .variant = 1}).curve);
    EXPECT_NE(next_frame(style, line, first, 1, 0).curve, first.curve);
  }
}

// The point that is pinned at that share of the line.
Point place_at(const StyledCurve& drawn, double share) {
  const double length = share * arc_length(s_curve());
  const auto nearer = [&](std::size_t a, std::size_t b) {
    return std::abs(drawn.lengths[a] - length) < std::abs(drawn.lengths[b] - length);
  };
  return drawn.curve.points[*std::ranges::min_element(drawn.pinned, nearer)];
}

// The mean distance of a frame from the one before, at the same lengths along the line.
double mean_move(const CurveAnalogy& style, double coherence) {
  const Polyline line = polyline("0 0, 2000 0");
  double sum = 0, count = 0;
  StyledCurve before = style.draw(line, {3});
  for (std::uint64_t frame = 1; frame <= 24; ++frame) {
    const StyledCurve after = next_frame(style, line, before, frame, coherence);
    for (double s = 5; s < 2000; s += 10) {
      const auto at = [&](const StyledCurve& drawn) {
        const auto i = std::ranges::lower_bound(drawn.lengths, s) - drawn.lengths.begin();
        return drawn.curve.points[static_cast<std::size_t>(i)];
      };
      sum += distance(at(before), at(after));
      count += 1;
    }
    before = after;
  }
  return sum / count;
}

TEST(CurveAnalogy, FramesMoveLessTheMoreCoherentTheyAre) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  double last = mean_move(style, 0);
  EXPECT_GT(last, 2);
  for (const double coherence : {0.3, 0.6, 0.9}) {
    const double move = mean_move(style, coherence);
    EXPECT_LT(move, 0.85 * last);
    last = move;
  }
  EXPECT_GT(last, 0);
  EXPECT_EQ(mean_move(style, 1), 0);
}

TEST(CurveAnalogy, LateFramesBendAsLinesDrawnAfresh) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  const double spacing = arc_length(pair.filtered.polyline) / 1200;
  for (const Polyline& line : {s_curve(), egg()}) {
    StyledCurve frame = style.draw(line, {3});
    double late = 0, afresh = 0;
    for (std::uint64_t i = 1; i <= 60; ++i) {
      frame = next_frame(style, line, frame, i, 0.5);
      std::size_t most = 0;
      for (const ChainRun& run : frame.runs) most = std::max(most, run.steps);
      EXPECT_LT(4 * most, style.example().state_count());
      if (i <= 20) continue;
      const Polyline other = style.draw(line, {.place = 3, .held = {}, .variant = i}).curve;
      late += turning_distance(pair.filtered.polyline, frame.curve, spacing);
      afresh += turning_distance(pair.filtered.polyline, other, spacing);
    }
    EXPECT_LT(late, 1.4 * afresh);
  }
}

// What a soft constraint comes to is settled in the first frame: it does not tremble.
TEST(CurveAnalogy, FramesPassSoftConstraintsWhereTheFirstDid) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  for (const double weight : {0.001, 0.01, 1.0}) {
    const std::vector<CurveConstraint> constraints = {{0.4, {250, 30}, weight}};
    CurveTask task{.place = 3, .held = {}, .variant = 0, .constraints = constraints};
    StyledCurve frame = style.draw(s_curve(), task);
    const Point settled = place_at(frame, 0.4);
    for (std::uint64_t i = 1; i <= 12; ++i) {
      const StyledCurve before = std::move(frame);
      task.variant = i;
      task.before = &before.walks;
      task.coherence = 0.5;
      frame = style.draw(s_curve(), task);
      EXPECT_LT(distance(place_at(frame, 0.4), settled), 1e-6);
    }
    EXPECT_NE(frame.curve,
              style.draw(s_curve(), {.place = 3, .held = {}, .constraints = constraints}).curve);
  }
}

}  // namespace
}  // namespace libstyle
