// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/curve_analogy.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libstyle/base/error.h"
#include "libstyle/base/parallel.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/gaussian.h"
#include "libstyle/geometry/rigid_alignment.h"
#include "libstyle/geometry/turning_statistics.h"
#include "tests/support/analogy_examples.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

// ---- Identities -----------------------------------------------------------------------------

TEST(CurveAnalogy, AnExampleThatChangesNothingGivesBackTheCurve) {
  RandomValues random(8);
  ExamplePair pair;
  pair.filtered = with_length_parameter(random_stroke(random, 600));
  pair.unfiltered = pair.filtered;
  pair.same_parameter = true;
  for (const double shape_weight : {0.0, 2.0}) {
    CurveAnalogyParameters parameters;
    parameters.shape_weight = shape_weight;
    const CurveAnalogy style({&pair, 1}, parameters);
    for (const Polyline& curve : {s_curve(), circle({0, 0}, 90, 200)}) {
      const StyledCurve drawn = style.draw(curve, {});
      for (const Point p : drawn.curve.points) EXPECT_LT(distance_from(curve, p), 0.01);
      EXPECT_NEAR(arc_length(drawn.curve), arc_length(curve), 0.01 * arc_length(curve));
    }
  }
}

// ---- Shapes -----------------------------------------------------------------------------------

// A square whose corners are drawn as points, the first of them where it closes.
ExamplePair pointed_square() {
  ExamplePair pair;
  pair.unfiltered = with_length_parameter(polyline("0 0, 200 0, 200 200, 0 200 z"));
  pair.filtered =
      with_length_parameter(polyline("-8 -8, 12 0, 188 0, 208 -8, 200 12, 200 188, 208 208, 188 "
                                     "200, 12 200, -8 208, 0 188, 0 12 z"));
  return pair;
}

TEST(CurveAnalogy, AClosedExampleGoesOnWhereItCloses) {
  const ExamplePair pair = pointed_square();
  CurveAnalogyParameters parameters;
  parameters.shape_weight = 2;
  for (const Invariance invariance : {Invariance::kRotate, Invariance::kTranslate}) {
    parameters.invariance = invariance;
    const CurveAnalogy style({&pair, 1}, parameters);
    // It begins and closes in the middle of a side.
    const Polyline curve = polyline("150 0, 300 0, 300 300, 0 300, 0 0 z");
    const Polyline drawn = style.draw(curve, {}).curve;
    for (const Point corner : {Point{-8, -8}, {308, -8}, {308, 308}, {-8, 308}}) {
      EXPECT_LT(distance_from(drawn, corner), 2) << corner.x << ' ' << corner.y;
    }
  }
}

// The sharpest turn within `reach` of a curve.
double sharpest_turn(const Polyline& curve, double reach) {
  const Polyline even = resample(with_length_parameter(curve), reach).polyline;
  double sharpest = 0;
  for (const double angle : turning_angles(even, 1)) sharpest = std::max(sharpest, std::abs(angle));
  return sharpest;
}

TEST(CurveAnalogy, CornersAreAsRoundAsThoseOfTheExample) {
  ExamplePair pair;
  const Polyline zigzag = polyline("0 0, 100 80, 200 0, 300 80, 400 0, 500 80, 600 0");
  pair.unfiltered = with_length_parameter(resample(with_length_parameter(zigzag), 0.5).polyline);
  pair.filtered = pair.unfiltered.value();
  pair.filtered.polyline = gaussian_blur(pair.filtered.polyline, 6);
  pair.same_parameter = true;
  CurveAnalogyParameters parameters;
  parameters.shape_weight = 2;
  parameters.feature_size = 12;
  parameters.invariance = Invariance::kTranslate;
  const CurveAnalogy style({&pair, 1}, parameters);
  for (const double height : {50.0, 65.0, 80.0, 95.0, 110.0}) {
    const Polyline line{{{0, 0}, {100, height}, {200, 0}, {300, height}, {400, 0}}, false};
    const Polyline drawn = style.draw(line, {}).curve;
    const double blurred =
        sharpest_turn(gaussian_blur(resample(with_length_parameter(line), 0.5).polyline, 6), 2);
    EXPECT_LT(sharpest_turn(drawn, 2), 1.5 * blurred) << height;
  }
}

// Every state that a line is drawn from, in order.
std::vector<std::size_t> states_of(const StyledCurve& drawn) {
  std::vector<std::size_t> states;
  for (const ChainRun& run : drawn.runs) {
    for (std::size_t i = 0; i < run.steps; ++i) states.push_back(run.origin + i);
  }
  return states;
}

TEST(CurveAnalogy, TheEndsOfAnExampleBelongAtEnds) {
  ExamplePair pair;
  pair.unfiltered = with_length_parameter(polyline("0 0, 0 200, 200 200"));
  pair.filtered = with_length_parameter(
      polyline("-8 12, -12 2, -6 -4, 4 6, 2 190, 10 198, 190 196, 204 202, 206 212, 196 214"));
  CurveAnalogyParameters parameters;
  parameters.shape_weight = 2;
  parameters.invariance = Invariance::kTranslate;  // so that most directions are not in it
  const CurveAnalogy style({&pair, 1}, parameters);
  const double feature = style.example().feature_along();
  for (int turn = 0; turn < 12; ++turn) {
    Polyline arc;
    for (int i = 0; i <= 100; ++i) {
      const double angle = std::numbers::pi * (turn / 6.0 + i / 75.0);
      arc.points.push_back({300 * std::cos(angle), 300 * std::sin(angle)});
    }
    const std::vector<std::size_t> states = states_of(style.draw(arc, {}));
    const double end = style.example().lines()[0].length();
    const auto margin = static_cast<std::size_t>(2 * feature / style.example().step()) + 1;
    for (std::size_t i = margin; i + margin < states.size(); ++i) {
      const double length = style.example().length_of(states[i]) + style.example().step() / 2;
      EXPECT_GT(std::min(length, end - length), 0.5 * feature) << turn << ", step " << i;
    }
  }
}

TEST(CurveAnalogy, AShiftedExampleShiftsTheCurve) {
  RandomValues random(9);
  ExamplePair pair;
  pair.filtered = with_length_parameter(random_stroke(random, 600));
  pair.unfiltered = pair.filtered;
  pair.same_parameter = true;
  const Vector shift = {7, -4};
  for (Point& p : pair.filtered.polyline.points) p += shift;
  CurveAnalogyParameters parameters;
  parameters.invariance = Invariance::kTranslate;
  parameters.keep_ends = false;
  const Polyline curve = s_curve();
  for (const Point p : draw_by_analogy(pair, curve, parameters).curve.points) {
    EXPECT_LT(distance_from(curve, p - shift), 0.01);
  }
}

TEST(CurveAnalogy, MovingAndTurningEverythingMovesTheResultAlike) {
  const RigidTransform scene{std::cos(0.7), std::sin(0.7), {310, -95}};
  for (const double shape_weight : {0.0, 2.0}) {
    CurveAnalogyParameters parameters;
    parameters.shape_weight = shape_weight;
    // A circle would not do: with shape_weight, all places of it are equally good.
    for (const Polyline& curve : {s_curve(), egg()}) {
      const Polyline there =
          transformed(draw_by_analogy(wavy_pair(), curve, parameters).curve, scene);
      const Polyline here =
          draw_by_analogy(transformed(wavy_pair(), scene), transformed(curve, scene), parameters)
              .curve;
      EXPECT_THAT(here, PolylineNear(there, 1e-7));
    }
  }
}

TEST(CurveAnalogy, TurningOnlyTheCurveTurnsTheResult) {
  const RigidTransform turn{std::cos(2), std::sin(2), {5, 5}};
  const Polyline there = transformed(draw_by_analogy(wavy_pair(), s_curve()).curve, turn);
  const Polyline here = draw_by_analogy(wavy_pair(), transformed(s_curve(), turn)).curve;
  EXPECT_THAT(here, PolylineNear(there, 1e-7));
}

TEST(CurveAnalogy, TranslationKeepsTheDirectionOfTheStyle) {
  // The example strays along y only; so does what is drawn, whatever the line's direction.
  CurveAnalogyParameters parameters;
  parameters.invariance = Invariance::kTranslate;
  const Polyline line = polyline("0 0, 0 300");
  const StyledCurve drawn = draw_by_analogy(wavy_pair(), line, parameters);
  for (const Point p : drawn.curve.points) EXPECT_NEAR(p.x, 0, 1e-9);
}

// ---- Ends, corners, closing -----------------------------------------------------------------

TEST(CurveAnalogy, OpenCurvesKeepTheirEndsExactly) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  for_each_seed(20, [&](std::uint64_t seed) {
    RandomValues random(seed);
    const Polyline curve = random_stroke(random, 20 + random.below(400));
    const StyledCurve drawn = style.draw(curve, {seed});
    EXPECT_EQ(drawn.curve.points.front(), curve.points.front());
    EXPECT_EQ(drawn.curve.points.back(), curve.points.back());
  });
}

TEST(CurveAnalogy, OutlinesKeepTheirCornersExactly) {
  const Polyline outline = polyline("0 0, 200 0, 200 120, 0 120 z");
  const StyledCurve drawn = draw_by_analogy(wavy_pair(), outline);
  EXPECT_TRUE(drawn.curve.closed);
  ASSERT_EQ(drawn.corners.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(drawn.curve.points[drawn.corners[i]], outline.points[i]);
  }
}

TEST(CurveAnalogy, PassesThroughHeldPlacesExactly) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  // With a corner away from its first point, so that its last line goes on past the seam.
  const Polyline drop =
      polyline("100 100, 150 130, 170 180, 150 240, 100 260, 0 260, 0 160, 40 110 z");
  for (const Polyline& curve : {s_curve(), egg(), drop, polyline("0 0, 200 0, 200 120, 0 120 z")}) {
    const ArcLength along(curve);
    const double held[] = {0.04 * along.total(), 0.31 * along.total(), 0.78 * along.total()};
    for (std::uint64_t place = 0; place < 5; ++place) {
      const StyledCurve drawn = style.draw(curve, {place, held});
      for (const double length : held) {
        EXPECT_LT(distance_from(drawn.curve, along.point_at(length)), 1e-6);
      }
    }
  }
}

TEST(CurveAnalogy, ClosedCurvesCloseWithoutASeam) {
  const ExamplePair pair = wavy_pair();
  for (const double shape_weight : {0.0, 2.0}) {
    CurveAnalogyParameters parameters;
    parameters.shape_weight = shape_weight;
    const CurveAnalogy style({&pair, 1}, parameters);
    for (std::uint64_t place = 0; place < 8; ++place) {
      const StyledCurve drawn = style.draw(egg(), {place});
      EXPECT_TRUE(drawn.curve.closed);
      const double gap = distance(drawn.curve.points.back(), drawn.curve.points.front());
      const double mean = arc_length(drawn.curve) / static_cast<double>(drawn.curve.points.size());
      EXPECT_LT(gap, 4 * mean);
    }
  }
}

// ---- Likeness -------------------------------------------------------------------------------

TEST(CurveAnalogy, BendsLikeTheExample) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  for_each_seed(20, [&](std::uint64_t seed) {
    const StyledCurve drawn = style.draw(s_curve(), {seed});
    const double spacing = arc_length(pair.filtered.polyline) / 1200;
    EXPECT_LT(turning_distance(pair.filtered.polyline, drawn.curve, spacing), 0.05);
  });
}

TEST(CurveAnalogy, FollowsTheCurve) {
  const Polyline curve = s_curve();
  const StyledCurve drawn = draw_by_analogy(wavy_pair(), curve);
  for (const Point p : drawn.curve.points) EXPECT_LT(distance_from(curve, p), 12);
}

TEST(CurveAnalogy, WithShapeWeightBringsBackTheExampleOnItsOwnLine) {
  // An unfiltered line with one hump, whose hump was drawn with a curl of its own.
  ExamplePair pair;
  Polyline plain, filtered;
  for (int i = 0; i <= 600; ++i) {
    const double x = 0.5 * i, hump = 30 * std::exp(-0.5 * std::pow((x - 150) / 20, 2));
    plain.points.push_back({x, hump});
    filtered.points.push_back({x, hump + 0.1 * hump * std::sin(x)});
  }
  pair.filtered = with_length_parameter(filtered);
  pair.unfiltered = with_length_parameter(plain);
  pair.filtered.t = pair.unfiltered->t;
  pair.same_parameter = true;
  CurveAnalogyParameters parameters;
  parameters.shape_weight = 2;
  const StyledCurve drawn = draw_by_analogy(pair, plain, parameters);
  ASSERT_EQ(drawn.runs.size(), 1u);
  for (const Point p : drawn.curve.points) EXPECT_LT(distance_from(filtered, p), 0.5);
}

TEST(CurveAnalogy, RunsCoverTheCurveAndVary) {
  const StyledCurve drawn = draw_by_analogy(wavy_pair(), s_curve());
  std::size_t next = 0;
  for (const ChainRun& run : drawn.runs) {
    EXPECT_EQ(run.first, next);
    next += run.steps;
  }
  EXPECT_GT(drawn.runs.size(), 3u);
}

TEST(CurveAnalogy, NoRunIsAQuarterOfTheExample) {
  const ExamplePair pair = wavy_pair();
  const Polyline line = polyline("0 0, 6000 0");
  for_each_seed(5, [&](std::uint64_t seed) {
    CurveAnalogyParameters parameters;
    parameters.seed = seed;
    const CurveAnalogy style({&pair, 1}, parameters);
    for (const ChainRun& run : style.draw(line, {}).runs) {
      EXPECT_LT(4 * run.steps, style.example().state_count());
    }
  });
}

TEST(CurveAnalogy, AnExampleLeftOutIsTheBlurredOne) {
  ExamplePair pair = wavy_pair();
  pair.unfiltered.reset();
  const StyledCurve drawn = draw_by_analogy(pair, s_curve());
  const double spacing = arc_length(pair.filtered.polyline) / 1200;
  EXPECT_LT(turning_distance(pair.filtered.polyline, drawn.curve, spacing), 0.06);
}

// ---- Sameness -------------------------------------------------------------------------------

TEST(CurveAnalogy, TheSameSeedGivesTheSameBytesOnAnyNumberOfThreads) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  std::vector<Polyline> first(12), second(12);
  parallel_for(12, 1, [&](std::size_t i) { first[i] = style.draw(s_curve(), {i}).curve; });
  parallel_for(12, 2, [&](std::size_t i) { second[i] = style.draw(s_curve(), {i}).curve; });
  EXPECT_EQ(first, second);
}

TEST(CurveAnalogy, SeedsAndPlacesDiffer) {
  const ExamplePair pair = wavy_pair();
  CurveAnalogyParameters other;
  other.seed = 2;
  const Polyline drawn = CurveAnalogy({&pair, 1}, {}).draw(s_curve(), {}).curve;
  EXPECT_NE(drawn, CurveAnalogy({&pair, 1}, {}).draw(s_curve(), {1}).curve);
  EXPECT_NE(drawn, CurveAnalogy({&pair, 1}, other).draw(s_curve(), {}).curve);
}

// ---- Curves and examples that are hardly any ------------------------------------------------

TEST(CurveAnalogy, DegenerateCurvesComeBackAsTheyAre) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  for (const char* text : {"", "3 4", "3 4, 3 4", "3 4, 3 4, 3 4 z", "0 0, 0.001 0"}) {
    EXPECT_EQ(style.draw(polyline(text), {}).curve, polyline(text)) << text;
  }
}

TEST(CurveAnalogy, EndlessCurvesComeBackAsTheyAre) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  for (const char* text : {"0 0, 1e9 0", "0 0, 1e200 0", "-1e308 0, 1e308 5, 0 0 z"}) {
    const StyledCurve drawn = style.draw(polyline(text), {});
    EXPECT_EQ(drawn.curve, polyline(text)) << text;
    EXPECT_TRUE(drawn.too_long);
  }
}

TEST(CurveAnalogy, WildCurvesGiveFiniteResults) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  for_each_seed(60, [&](std::uint64_t seed) {
    RandomValues random(seed);
    Polyline curve =
        random_scribble(random, 2 + random.below(30), std::pow(10, random.uniform(-2, 3)));
    if (random.chance(0.3)) curve.points.push_back(curve.points.back());
    curve.closed = random.chance(0.5);
    const StyledCurve drawn = style.draw(curve, {seed});
    EXPECT_EQ(drawn.curve.closed, curve.closed);
    EXPECT_EQ(drawn.lengths.size(), drawn.curve.points.size());
    EXPECT_TRUE(std::ranges::is_sorted(drawn.lengths));
    for (const Point p : drawn.curve.points) EXPECT_TRUE(is_finite(p));
  });
}

TEST(CurveAnalogy, ShortAndOddExamplesServe) {
  for (const char* text : {"0 0, 10 0", "0 0, 10 0, 13 9, 16 0, 26 0", "0 0, 1 1",
                           "0 0, 50 0, 50 0, 90 3", "0 0, 10 0, 10 10, 0 10 z"}) {
    ExamplePair pair;
    pair.filtered = with_length_parameter(polyline(text));
    for (const Point p : draw_by_analogy(pair, s_curve()).curve.points) {
      EXPECT_TRUE(is_finite(p)) << text;
    }
  }
}

TEST(CurveAnalogy, RefusesExamplesThatCannotServe) {
  ExamplePair pair;
  pair.filtered = with_length_parameter(polyline("3 4"));
  EXPECT_THROW(draw_by_analogy(pair, s_curve()), Error);
  pair.filtered = with_length_parameter(polyline("0 0, 9 9"));
  pair.filtered.polyline.points[1].x = std::nan("");
  EXPECT_THROW(draw_by_analogy(pair, s_curve()), Error);
  pair.filtered = with_length_parameter(polyline("0 0, 1e200 9"));
  EXPECT_THROW(draw_by_analogy(pair, s_curve()), Error);
  EXPECT_THROW(CurveAnalogy({}, {}), Error);
}

}  // namespace
}  // namespace libstyle
