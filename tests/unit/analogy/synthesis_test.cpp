// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/synthesis.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libstyle/base/error.h"
#include "libstyle/base/parallel.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/turning_statistics.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"
#include "tests/support/repetition.h"

namespace libstyle {
namespace {

constexpr std::uint64_t kSeeds = 24;

// A coast: bays within bays, 1,200 points.
Polyline coast() {
  RandomValues random(5);
  return random_stroke(random, 1200);
}

Polyline loops() {
  RandomValues random(3);
  Polyline result;
  double phase = 0, pace = 1, x = 0;
  for (int i = 0; i < 1200; ++i) {
    pace += 0.05 * (1 - pace) + random.normal(0.03);
    phase += 0.12 * pace;
    x += 0.6;
    result.points.push_back({x + 12 * std::sin(phase), 12 * std::cos(phase)});
  }
  return result;
}

CurveAnalogyParameters with_seed(std::uint64_t seed,
                                 Invariance invariance = Invariance::kTranslate) {
  CurveAnalogyParameters parameters;
  parameters.seed = seed;
  parameters.invariance = invariance;
  return parameters;
}

SynthesizedCurve synthesize(const Polyline& example, const CurveAnalogyParameters& parameters,
                            double length) {
  return CurveSynthesis({&example, 1}, parameters).draw(length, 0);
}

// How far `b` is from `a` turned and stretched by `turn`, where both are as far along.
double farthest(const Polyline& a, const Polyline& b, Vector turn = {1, 0}) {
  const ArcLength along_a(a), along_b(b);
  double most = 0;
  for (int i = 0; i <= 1000; ++i) {
    const Point p = along_a.point_at(along_a.total() * i / 1000);
    most = std::max(most, distance(to_page(p, turn), along_b.point_at(along_b.total() * i / 1000)));
  }
  return most;
}

// The halves of a curve, evenly sampled.
double distance_of_halves(const Polyline& curve, double spacing) {
  const ArcLength along(curve);
  Polyline halves[2];
  for (int half = 0; half < 2; ++half) {
    for (double s = 0; s <= along.total() / 2; s += spacing) {
      halves[half].points.push_back(along.point_at(half * along.total() / 2 + s));
    }
  }
  return turning_distance(halves[0], halves[1], spacing);
}

// --- Identities ---------------------------------------------------------------------------------

TEST(CurveSynthesis, HasTheLengthThatWasAskedFor) {
  const Polyline example = coast();
  for (const double length : {3.0, 100.0, 2500.0}) {
    EXPECT_NEAR(arc_length(synthesize(example, with_seed(1), length).curve), length, 1e-9 * length);
  }
}

TEST(CurveSynthesis, BeginsAtTheOriginAndHasNoPointTwice) {
  const Polyline curve = synthesize(coast(), with_seed(1), 2000).curve;
  EXPECT_EQ(curve.points.front(), (Point{0, 0}));
  EXPECT_EQ(std::ranges::adjacent_find(curve.points), curve.points.end());
  EXPECT_FALSE(curve.closed);
}

TEST(CurveSynthesis, CopiesAStraightLineAsAStraightLine) {
  const SynthesizedCurve drawn = synthesize(polyline("0 0, 30 40"), with_seed(1), 200);
  EXPECT_NEAR(distance(drawn.curve.points.back(), {120, 160}), 0, 1e-9);
}

TEST(CurveSynthesis, DoesNotCareWhereTheExampleLies) {
  const Polyline example = coast();
  Polyline moved = example;
  for (Point& p : moved.points) p += {1000, -300};
  const Polyline a = synthesize(example, with_seed(7), 2000).curve;
  const Polyline b = synthesize(moved, with_seed(7), 2000).curve;
  EXPECT_LT(farthest(a, b), 1e-7);
}

TEST(CurveSynthesis, TurnsWithTheExample) {
  const Vector turn = {std::cos(0.7), std::sin(0.7)};
  const Polyline example = coast();
  Polyline turned = example;
  for (Point& p : turned.points) p = to_page(p, turn);
  const auto parameters = with_seed(7, Invariance::kRotate);
  const Polyline a = synthesize(example, parameters, 2000).curve;
  const Polyline b = synthesize(turned, parameters, 2000).curve;
  EXPECT_LT(farthest(a, b, turn), 1e-7);
}

// An arc of any length makes the whole circle, round and round.
TEST(CurveSynthesis, TurnedPiecesGoOnInTheDirectionOfTheLast) {
  const Polyline example = arc({0, 0}, 50, 0, 3, 300);
  for_each_seed(5, [&](std::uint64_t seed) {
    const Polyline curve = synthesize(example, with_seed(seed, Invariance::kRotate), 1000).curve;
    for (const double turn : turning_angles(curve, 1)) EXPECT_LT(std::abs(turn), 0.2);
  });
}

TEST(CurveSynthesis, FollowsTheScale) {
  const Polyline example = coast();
  CurveAnalogyParameters large = with_seed(7);
  large.scale = 3;
  const Polyline a = synthesize(example, with_seed(7), 700).curve;
  const Polyline b = synthesize(example, large, 2100).curve;
  EXPECT_LT(farthest(a, b, {3, 0}), 1e-7);
}

TEST(CurveSynthesis, IsTheSameEveryTimeAndOtherwiseAnother) {
  const Polyline example = loops();
  const Polyline once = synthesize(example, with_seed(1), 2000).curve;
  EXPECT_EQ(synthesize(example, with_seed(1), 2000).curve, once);
  EXPECT_NE(synthesize(example, with_seed(2), 2000).curve, once);
  EXPECT_NE(CurveSynthesis({&example, 1}, with_seed(1)).draw(2000, 1).curve, once);
}

TEST(CurveSynthesis, CopiesWhatGoesAlongTheExample) {
  ExamplePair pair{std::nullopt, with_length_parameter(coast())};
  const double length = arc_length(pair.filtered.polyline);
  pair.features = {{"width", FeatureKind::kLength}, {"s", FeatureKind::kNumber}};
  pair.filtered.channels.resize(2);
  for (const double t : pair.filtered.t) {
    pair.filtered.channels[0].push_back(2 + std::sin(length * t / 30));
    pair.filtered.channels[1].push_back(length * t);
  }
  const CurveSynthesis style({&pair, 1}, with_seed(3));
  const SynthesizedCurve drawn = style.draw(1.5 * length, 0);
  ASSERT_EQ(drawn.features[0].size(), drawn.curve.points.size());
  // Where nothing fades, both come from the same place.
  std::size_t same = 0;
  for (std::size_t i = 0; i < drawn.curve.points.size(); ++i) {
    const double width = 2 + std::sin(drawn.features[1][i] / 30);
    same += std::abs(drawn.features[0][i] - width) < 0.05;
  }
  EXPECT_GT(static_cast<double>(same), 0.5 * static_cast<double>(drawn.curve.points.size()));
}

// --- Likeness and variety, over seeds -----------------------------------------------------------

struct Figures {
  double mean_distance = 0;
  double largest_run = 0;     // share of the example
  double least_coverage = 1;  // of the example
  double largest_repeat = 0;  // share of steps that are the same so many steps later, any number
  double mean_median = 0;     // of the runs, in 1/1200 of the example
};

Figures measure(const Polyline& example) {
  const double length = arc_length(example);
  std::vector<Figures> each(kSeeds);
  parallel_for(kSeeds, 0, [&](std::size_t seed) {
    const CurveSynthesis style({&example, 1}, with_seed(seed));
    const SynthesizedCurve drawn = style.draw(2 * length, 0);
    const auto states = static_cast<double>(style.example().state_count());
    std::vector<bool> used(style.example().state_count());
    std::vector<std::size_t> sizes;
    for (const ChainRun& run : drawn.runs) {
      sizes.push_back(run.steps);
      std::fill_n(used.begin() + run.origin, run.steps, true);
    }
    std::ranges::sort(sizes);
    each[seed] = {turning_distance(example, drawn.curve, length / 1200),
                  static_cast<double>(sizes.back()) / states,
                  static_cast<double>(std::ranges::count(used, true)) / states,
                  repetition(drawn.runs),
                  1200 * static_cast<double>(sizes[sizes.size() / 2]) / states};
  });
  Figures all;
  for (const Figures& one : each) {
    all.mean_distance += one.mean_distance / kSeeds;
    all.largest_run = std::max(all.largest_run, one.largest_run);
    all.least_coverage = std::min(all.least_coverage, one.least_coverage);
    all.largest_repeat = std::max(all.largest_repeat, one.largest_repeat);
    all.mean_median += one.mean_median / kSeeds;
  }
  return all;
}

void expect_likeness_and_variety(const Polyline& example) {
  const Figures figures = measure(example);
  EXPECT_LT(figures.mean_distance, distance_of_halves(example, arc_length(example) / 1200));
  EXPECT_LT(figures.largest_run, 0.25);
  EXPECT_GT(figures.least_coverage, 0.6);
  EXPECT_LT(figures.largest_repeat, 0.5);
  EXPECT_GT(figures.mean_median, 10);
  EXPECT_LT(figures.mean_median, 60);
}

TEST(CurveSynthesis, ACoastIsLikeItsExampleAndDoesNotRepeatIt) {
  expect_likeness_and_variety(coast());
}

TEST(CurveSynthesis, LoopsAreLikeTheirExampleAndDoNotRepeatIt) {
  expect_likeness_and_variety(loops());
}

// --- Constraints --------------------------------------------------------------------------------

// Coarsely cut: many curves are drawn.
CurveSynthesis coarse_style(const Polyline& example,
                            Invariance invariance = Invariance::kTranslate) {
  CurveAnalogyParameters parameters = with_seed(1, invariance);
  parameters.samples = 300;
  return CurveSynthesis({&example, 1}, parameters);
}

std::vector<Invariance> both_invariances() { return {Invariance::kTranslate, Invariance::kRotate}; }

TEST(CurveSynthesis, PassesThroughHardConstraintsExactly) {
  const Polyline example = coast();
  const CurveConstraint constraints[] = {
      {0, {10, 20}, {}}, {0.4, {120, -40}, {}}, {1, {290, 77}, {}}};
  for (const Invariance invariance : both_invariances()) {
    const CurveSynthesis style = coarse_style(example, invariance);
    for_each_seed(kSeeds, [&](std::uint64_t seed) {
      const SynthesizedCurve drawn = style.draw(500, seed, 0, constraints);
      EXPECT_EQ(drawn.curve.points.front(), constraints[0].position);
      EXPECT_EQ(drawn.curve.points[drawn.pinned[1]], constraints[1].position);
      EXPECT_EQ(drawn.curve.points.back(), constraints[2].position);
    });
  }
}

TEST(CurveSynthesis, GrowsBothWaysFromOneConstraint) {
  const Polyline example = coast();
  const CurveConstraint constraint{0.5, {-30, 200}, {}};
  const CurveSynthesis style = coarse_style(example);
  for_each_seed(kSeeds, [&](std::uint64_t seed) {
    const SynthesizedCurve drawn = style.draw(500, seed, 0, {&constraint, 1});
    const Polyline free = style.draw(500, seed).curve;
    EXPECT_EQ(drawn.curve.points[drawn.pinned[0]], constraint.position);
    EXPECT_NEAR(arc_length(drawn.curve), 500, 1e-6);
    EXPECT_LT(turning_distance(free, drawn.curve, 1), 1e-3);
  });
}

TEST(CurveSynthesis, HeavierConstraintsAreMetMoreNearly) {
  const Polyline example = coast();
  const CurveSynthesis style = coarse_style(example);
  for_each_seed(kSeeds, [&](std::uint64_t seed) {
    double last = HUGE_VAL;
    for (const double weight : {1e-6, 1e-4, 0.01, 1.0}) {
      const CurveConstraint constraints[] = {{0, {0, 0}, {}}, {1, {400, 400}, weight}};
      const double left =
          distance(style.draw(500, seed, 0, constraints).curve.points.back(), {400, 400});
      EXPECT_LT(left, last) << weight;
      last = left;
    }
    EXPECT_LT(last, 1);
  });
}

TEST(CurveSynthesis, MovesWithItsConstraints) {
  const Polyline example = coast();
  const Vector turn = {std::cos(0.7), std::sin(0.7)}, shift = {1000, -300};
  const CurveSynthesis upright = coarse_style(example);
  const CurveSynthesis free = coarse_style(example, Invariance::kRotate);
  for_each_seed(kSeeds, [&](std::uint64_t seed) {
    std::vector<CurveConstraint> here = {
        {0.1, {0, 0}, {}}, {0.5, {160, 40}, 0.01}, {0.9, {200, 9}, {}}};
    std::vector<CurveConstraint> moved = here, turned = here;
    for (CurveConstraint& c : moved) c.position += shift;
    for (CurveConstraint& c : turned) c.position = to_page(c.position, turn);
    Polyline a = upright.draw(500, seed, 0, here).curve;
    for (Point& p : a.points) p += shift;
    EXPECT_THAT(upright.draw(500, seed, 0, moved).curve, PolylineNear(a, 1e-9));
    Polyline b = free.draw(500, seed, 0, here).curve;
    for (Point& p : b.points) p = to_page(p, turn);
    EXPECT_THAT(free.draw(500, seed, 0, turned).curve, PolylineNear(b, 1e-9));
  });
}

// From one place to another, no nearer than half the length of the line, in several directions.
TEST(CurveSynthesis, BetweenConstraintsIsStillLikeItsExample) {
  for (const Polyline& example : {coast(), loops()}) {
    const double halves = distance_of_halves(example, arc_length(example) / 1200);
    const Vector along = normalized(example.points.back() - example.points.front());
    const double pace =
        distance(example.points.back(), example.points.front()) / arc_length(example);
    double sum = 0;
    const CurveSynthesis style = coarse_style(example);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const double turn = 0.5 * std::sin(static_cast<double>(seed));
      const Vector way = to_page(along, {std::cos(turn), std::sin(turn)});
      const CurveConstraint constraints[] = {{0, {0, 0}, {}}, {1, 1500 * pace * way, {}}};
      sum += turning_distance(example, style.draw(1500, seed, 0, constraints).curve,
                              arc_length(example) / 1200);
    }
    EXPECT_LT(sum / kSeeds, halves);
  }
}

// --- Errors -------------------------------------------------------------------------------------

TEST(CurveSynthesis, RefusesWhatCannotServe) {
  const Polyline point = polyline("3 3"), good = polyline("0 0, 10 0");
  EXPECT_THROW(CurveSynthesis({&point, 1}, {}), Error);
  EXPECT_THROW(CurveSynthesis(std::span<const Polyline>(), {}), Error);
  const CurveSynthesis style({&good, 1}, {});
  for (const double length : {0.0, -1.0, std::nan(""), 1e300}) {
    EXPECT_THROW(style.draw(length, 0), Error) << length;
  }
}

TEST(CurveSynthesis, RefusesConstraintsThatCannotBe) {
  const Polyline example = coast();
  const CurveSynthesis style({&example, 1}, {});
  const auto draw = [&](std::vector<CurveConstraint> constraints) {
    style.draw(100, 0, 0, constraints);
  };
  EXPECT_NO_THROW(draw({{0, {0, 0}, {}}, {1, {99, 0}, {}}}));
  EXPECT_THROW(draw({{0, {0, 0}, {}}, {1, {101, 0}, {}}}), Error);
  EXPECT_THROW(draw({{0.4, {0, 0}, {}}, {0.5, {11, 0}, {}}}), Error);
  EXPECT_NO_THROW(draw({{0.4, {0, 0}, {}}, {0.5, {11, 0}, 1}}));
  EXPECT_THROW(draw({{0.4, {0, 0}, {}}, {0.4, {1, 0}, {}}}), Error);
  EXPECT_THROW(draw({{1.1, {0, 0}, {}}}), Error);
}

TEST(CurveSynthesis, TakesExamplesOfAnyKind) {
  RandomValues random(1);
  for (const Polyline& example :
       {polyline("0 0, 1 0"), polyline("0 0, 0 0, 5 5, 5 5"), circle({0, 0}, 10, 30),
        random_scribble(random, 50, 10), polyline("0 0, 10 0, 0 0")}) {
    for (const Invariance invariance : {Invariance::kRotate, Invariance::kTranslate}) {
      const double length = 3 * arc_length(example);
      const Polyline curve = synthesize(example, with_seed(1, invariance), length).curve;
      EXPECT_NEAR(arc_length(curve), length, 1e-6);
    }
  }
}

}  // namespace
}  // namespace libstyle
