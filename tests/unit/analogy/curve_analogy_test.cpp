// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/curve_analogy.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "libstyle/base/error.h"
#include "libstyle/base/parallel.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/gaussian.h"
#include "libstyle/geometry/rigid_alignment.h"
#include "libstyle/geometry/segment_grid.h"
#include "libstyle/geometry/turning_statistics.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

// A wave whose size and pace wander, over a straight line.
Polyline wandering_wave(std::uint64_t seed, double length) {
  RandomValues random(seed);
  Polyline result;
  double phase = 0, pace = 1, size = 5;
  for (double x = 0; x <= length; x += 0.5) {
    pace += 0.02 * (1 - pace) + random.normal(0.02);
    size += 0.02 * (5 - size) + random.normal(0.1);
    phase += 2 * std::numbers::pi * 0.5 / 22 * pace;
    result.points.push_back({x, size * std::sin(phase)});
  }
  return result;
}

ExamplePair wavy_pair() {
  ExamplePair pair;
  pair.filtered.polyline = wandering_wave(11, 600);
  for (const Point p : pair.filtered.polyline.points) pair.filtered.t.push_back(p.x / 600);
  pair.unfiltered = with_length_parameter(polyline("0 0, 600 0"));
  pair.same_parameter = true;
  return pair;
}

Polyline s_curve() {
  Polyline result;
  for (int i = 0; i <= 200; ++i) {
    result.points.push_back({3.0 * i, 60 * std::sin(2 * std::numbers::pi * i / 200)});
  }
  return result;
}

Polyline egg() {
  Polyline result{{}, true};
  for (int i = 0; i < 120; ++i) {
    const double angle = 2 * std::numbers::pi * i / 120;
    result.points.push_back({(80 + 12 * std::cos(angle)) * std::cos(angle),
                             (60 + 9 * std::sin(3 * angle)) * std::sin(angle)});
  }
  return result;
}

Polyline transformed(Polyline curve, const RigidTransform& transform) {
  for (Point& p : curve.points) p = transform(p);
  return curve;
}

ExamplePair transformed(ExamplePair pair, const RigidTransform& transform) {
  pair.filtered.polyline = transformed(pair.filtered.polyline, transform);
  if (pair.unfiltered)
    pair.unfiltered->polyline = transformed(pair.unfiltered->polyline, transform);
  return pair;
}

double distance_from(const Polyline& curve, Point p) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < segment_count(curve); ++i) {
    const Point a = segment_start(curve, i), ab = segment_end(curve, i) - a;
    const double share = std::clamp(dot(p - a, ab) / squared_norm(ab), 0.0, 1.0);
    least = std::min(least, distance(p, a + share * ab));
  }
  return least;
}

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

// ---- Constraints ----------------------------------------------------------------------------

constexpr std::uint64_t kSeeds = 20;

Polyline outline() { return polyline("0 0, 200 0, 200 120, 0 120 z"); }

// How far the drawn curve is from a place.
double residual(const CurveAnalogy& style, const Polyline& curve, std::uint64_t place,
                const std::vector<CurveConstraint>& constraints, Point wanted) {
  return distance_from(style.draw(curve, {place, {}, 0, constraints}).curve, wanted);
}

std::vector<CurveConstraint> random_constraints(const Polyline& curve, RandomValues& random) {
  const ArcLength along(curve);
  std::vector<CurveConstraint> constraints;
  for (const double t : {random.uniform(0, 0.3), random.uniform(0.31, 0.6), 0.75}) {
    const Vector off = {random.normal(20), random.normal(20)};
    constraints.push_back({t, along.point_at(t * along.total()) + off, {}});
  }
  return constraints;
}

TEST(CurveAnalogy, MeetsHardConstraintsExactly) {
  const ExamplePair pair = wavy_pair();
  for (const double shape_weight : {0.0, 2.0}) {
    CurveAnalogyParameters parameters;
    parameters.shape_weight = shape_weight;
    const CurveAnalogy style({&pair, 1}, parameters);
    for_each_seed(kSeeds, [&](std::uint64_t seed) {
      RandomValues random(seed);
      for (const Polyline& curve : {s_curve(), egg(), outline()}) {
        const auto constraints = random_constraints(curve, random);
        const StyledCurve drawn = style.draw(curve, {seed, {}, 0, constraints});
        for (const CurveConstraint& c : constraints) {
          EXPECT_THAT(drawn.curve.points, ::testing::Contains(c.position));
        }
        EXPECT_EQ(drawn.curve.closed, curve.closed);
        EXPECT_TRUE(std::ranges::is_sorted(drawn.lengths));
      }
    });
  }
}

TEST(CurveAnalogy, ConstraintsMoveEndsAndCorners) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  for_each_seed(kSeeds, [&](std::uint64_t seed) {
    const CurveConstraint ends[] = {{0, {-20, 15}, {}}, {1, {630, -9}, {}}};
    const Polyline line = style.draw(s_curve(), {seed, {}, 0, ends}).curve;
    EXPECT_EQ(line.points.front(), ends[0].position);
    EXPECT_EQ(line.points.back(), ends[1].position);

    const CurveConstraint corner{200.0 / 640, {230, -12}, {}};
    const StyledCurve drawn = style.draw(outline(), {seed, {}, 0, {&corner, 1}});
    EXPECT_EQ(drawn.curve.points[drawn.corners[1]], corner.position);
    EXPECT_EQ(drawn.curve.points[drawn.corners[2]], (Point{200, 120}));
  });
}

TEST(CurveAnalogy, HeavierConstraintsAreMetMoreNearly) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  for_each_seed(kSeeds, [&](std::uint64_t seed) {
    RandomValues random(seed);
    for (const Polyline& curve : {s_curve(), egg(), outline()}) {
      const ArcLength along(curve);
      // At an end or corner now and then.
      const double t = random.chance(0.2) ? 0 : random.uniform(0.1, 0.9);
      const Point wanted = along.point_at(t * along.total()) +
                           Vector{random.uniform(40, 80), random.uniform(40, 80)};
      const auto at = [&](std::optional<double> weight) {
        const std::vector<CurveConstraint> constraint = {{t, wanted, weight}};
        const StyledCurve drawn = style.draw(curve, {seed, {}, 0, constraint});
        // The point that is `t` along.
        const auto after = std::ranges::lower_bound(drawn.lengths, t * along.total() - 1e-6);
        return distance(drawn.curve.points[static_cast<std::size_t>(after - drawn.lengths.begin())],
                        wanted);
      };
      double last = HUGE_VAL;
      for (const double weight : {1e-5, 1e-3, 0.1, 10.0, 1e6}) {
        const double left = at(weight);
        EXPECT_LT(left, last) << weight;
        last = left;
      }
      EXPECT_LT(last, 0.01);
      EXPECT_EQ(at({}), 0);
    }
  });
}

TEST(CurveAnalogy, MovingAndTurningConstraintsToo) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  for_each_seed(kSeeds, [&](std::uint64_t seed) {
    RandomValues random(seed);
    const double angle = random.uniform(0, 6);
    const RigidTransform scene{std::cos(angle), std::sin(angle), {310, -95}};
    for (const Polyline& curve : {s_curve(), egg(), outline()}) {
      std::vector<CurveConstraint> constraints = random_constraints(curve, random);
      constraints[1].weight = 0.01;
      const Polyline there =
          transformed(style.draw(curve, {seed, {}, 0, constraints}).curve, scene);
      for (CurveConstraint& c : constraints) c.position = scene(c.position);
      const Polyline here = style.draw(transformed(curve, scene), {seed, {}, 0, constraints}).curve;
      EXPECT_THAT(here, PolylineNear(there, 1e-9));
    }
  });
}

// Waves over a line do not cross themselves; nor do they where it is drawn ten features away.
TEST(CurveAnalogy, AConstraintFarOffDoesNotTangleTheCurve) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  const double far = 10 * style.example().feature_size();
  const Polyline line = polyline("0 0, 1200 0");
  for_each_seed(kSeeds, [&](std::uint64_t seed) {
    const double angle = static_cast<double>(seed) / kSeeds * 2 * std::numbers::pi;
    const CurveConstraint constraint{0.5, {600 + far * std::cos(angle), far * std::sin(angle)}, {}};
    const Polyline drawn = style.draw(line, {seed, {}, 0, {&constraint, 1}}).curve;
    EXPECT_THAT(SegmentGrid({&drawn, 1}).crossings(), ::testing::IsEmpty());
    const double spacing = arc_length(pair.filtered.polyline) / 1200;
    EXPECT_LT(turning_distance(pair.filtered.polyline, drawn, spacing), 0.05);
  });
}

TEST(CurveAnalogy, RefusesConstraintsThatCannotBeReached) {
  const ExamplePair pair = wavy_pair();
  const CurveAnalogy style({&pair, 1}, {});
  for (const double far : {1e9, 1e300}) {
    const CurveConstraint constraint{0.5, {300, far}, {}};
    EXPECT_THROW(style.draw(s_curve(), {0, {}, 0, {&constraint, 1}}), Error);
  }
}

TEST(CurveAnalogy, TheSearchMeetsConstraintsToo) {
  const ExamplePair pair = wavy_pair();
  CurveAnalogyParameters parameters;
  parameters.method = AnalogyMethod::kGreedy;
  parameters.samples = 300;
  const CurveAnalogy style({&pair, 1}, parameters);
  const std::vector<CurveConstraint> hard = {{0.3, {190, 75}, {}}, {1, {600, 20}, {}}};
  const Polyline drawn = style.draw(s_curve(), {0, {}, 0, hard}).curve;
  EXPECT_EQ(drawn.points.back(), hard[1].position);
  EXPECT_THAT(drawn.points, ::testing::Contains(hard[0].position));
  const Point wanted = {300, 15};
  double last = HUGE_VAL;
  for (const double weight : {1e-3, 1.0, 1e3}) {
    const double left = residual(style, s_curve(), 0, {{0.5, wanted, weight}}, wanted);
    EXPECT_LT(left, last) << weight;
    last = left;
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

// ---- Features ---------------------------------------------------------------------------------

// The wave in a width that wanders too, and with the length along the line.
ExamplePair brush_pair() {
  ExamplePair pair = wavy_pair();
  pair.features = {{"width", FeatureKind::kLength}, {"x", FeatureKind::kNumber}};
  pair.filtered.channels.resize(2);
  for (const Point p : pair.filtered.polyline.points) {
    pair.filtered.channels[0].push_back(3 + std::sin(p.x / 17) + 0.5 * std::sin(p.x / 7));
    pair.filtered.channels[1].push_back(p.x);
  }
  return pair;
}

TEST(CurveAnalogy, AnExampleThatChangesNothingGivesBackItsFeatures) {
  RandomValues random(8);
  ExamplePair pair;
  pair.filtered = with_length_parameter(random_stroke(random, 600));
  pair.unfiltered = pair.filtered;
  pair.same_parameter = true;
  pair.features = {{"width", FeatureKind::kLength}};
  pair.filtered.channels = {{}};
  for (const double t : pair.filtered.t) {
    pair.filtered.channels[0].push_back(3 + 2 * std::sin(40 * t));
  }
  CurveAnalogyParameters parameters;
  parameters.shape_weight = 2;
  parameters.smallest_scale = 1;
  const StyledCurve drawn = draw_by_analogy(pair, pair.filtered.polyline, parameters);
  ASSERT_EQ(drawn.runs.size(), 1u);
  ASSERT_EQ(drawn.features[0].size(), drawn.curve.points.size());
  const double length = drawn.lengths.back();
  for (std::size_t i = 0; i < drawn.lengths.size(); ++i) {
    EXPECT_NEAR(drawn.features[0][i], 3 + 2 * std::sin(40 * drawn.lengths[i] / length), 0.05);
  }
}

TEST(CurveAnalogy, FeaturesComeFromWhereTheShapeComesFrom) {
  const ExamplePair pair = brush_pair();
  const CurveAnalogy style({&pair, 1}, {});
  const Example& example = style.example();
  const Polyline line = polyline("0 0, 1000 0");
  for_each_seed(10, [&](std::uint64_t seed) {
    const StyledCurve drawn = style.draw(line, {seed});
    const double step =
        1000 / static_cast<double>(drawn.runs.back().first + drawn.runs.back().steps);
    for (const ChainRun& run : drawn.runs) {
      // In the middle of a run nothing fades.
      if (run.steps < 6) continue;
      const double middle = static_cast<double>(run.steps) / 2;
      const double length = (static_cast<double>(run.first) + middle) * step;
      const auto i = std::ranges::lower_bound(drawn.lengths, length) - drawn.lengths.begin();
      const double x = example.length_of(run.origin) + middle * example.step();
      EXPECT_NEAR(drawn.features[1][static_cast<std::size_t>(i)], x, 1);
    }
  });
}

// The mean difference of the widths of the example where one run follows another.
double mean_leap(const CurveAnalogy& style) {
  const Example& example = style.example();
  const auto width = [](double x) { return 3 + std::sin(x / 17) + 0.5 * std::sin(x / 7); };
  double sum = 0, count = 0;
  for (std::uint64_t place = 0; place < 20; ++place) {
    const std::vector<ChainRun> runs = style.draw(polyline("0 0, 1500 0"), {place}).runs;
    for (std::size_t i = 1; i < runs.size(); ++i) {
      const double from = example.length_of(runs[i - 1].origin) +
                          example.step() * static_cast<double>(runs[i - 1].steps);
      sum += std::abs(width(from) - width(example.length_of(runs[i].origin)));
      count += 1;
    }
  }
  return sum / count;
}

TEST(CurveAnalogy, WidthsDoNotLeap) {
  const ExamplePair brush = brush_pair();
  ExamplePair plain = brush;
  plain.features.clear();
  plain.filtered.channels.clear();
  EXPECT_LT(mean_leap(CurveAnalogy({&brush, 1}, {})),
            0.6 * mean_leap(CurveAnalogy({&plain, 1}, {})));
}

TEST(CurveAnalogy, WidthsAreThoseOfTheExample) {
  const ExamplePair pair = brush_pair();
  const CurveAnalogy style({&pair, 1}, {});
  const FeatureStatistics& widths = style.example().statistics(0);
  for_each_seed(10, [&](std::uint64_t seed) {
    const StyledCurve drawn = style.draw(polyline("0 0, 1500 0"), {seed});
    const std::vector<double>& own = drawn.features[0];
    double sum = 0;
    for (std::size_t i = 1; i < own.size(); ++i) {
      sum += own[i] * (drawn.lengths[i] - drawn.lengths[i - 1]);
    }
    EXPECT_NEAR(sum / 1500, widths.mean, 0.3 * widths.spread);
    EXPECT_LE(std::ranges::max(own), widths.extent);
  });
}

TEST(CurveAnalogy, WidthsHaveTheSizeOfTheStyleAndNumbersNone) {
  const ExamplePair pair = brush_pair();
  CurveAnalogyParameters large;
  large.scale = 3;
  const StyledCurve once = draw_by_analogy(pair, polyline("0 0, 500 0"));
  const StyledCurve thrice = draw_by_analogy(pair, polyline("0 0, 1500 0"), large);
  ASSERT_EQ(once.curve.points.size(), thrice.curve.points.size());
  for (std::size_t i = 0; i < once.curve.points.size(); ++i) {
    EXPECT_NEAR(thrice.features[0][i], 3 * once.features[0][i], 1e-6);
    EXPECT_NEAR(thrice.features[1][i], once.features[1][i], 1e-6);
  }
  // A line without room has all of the style smaller.
  const StyledCurve small = draw_by_analogy(pair, polyline("0 0, 10 0"));
  ASSERT_LT(small.mean_scale, 0.5);
  for (const double width : small.features[0]) {
    EXPECT_LE(width, small.mean_scale * 4.5);
    EXPECT_GE(width, small.mean_scale * 1.5);
  }
}

TEST(CurveAnalogy, TheGreedySearchCopiesFeaturesToo) {
  const ExamplePair pair = brush_pair();
  CurveAnalogyParameters parameters;
  parameters.method = AnalogyMethod::kGreedy;
  const StyledCurve drawn = draw_by_analogy(pair, polyline("0 0, 300 0"), parameters);
  ASSERT_EQ(drawn.features[0].size(), drawn.curve.points.size());
  for (std::size_t i = 0; i < drawn.curve.points.size(); ++i) {
    const double x = drawn.features[1][i];
    EXPECT_NEAR(drawn.features[0][i], 3 + std::sin(x / 17) + 0.5 * std::sin(x / 7), 0.05);
  }
}

// ---- Strokes ----------------------------------------------------------------------------------

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

// ---- Frames -----------------------------------------------------------------------------------

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

// ---- Values along closed examples ---------------------------------------------------------------

TEST(ExampleLine, ValuesAlongAClosedExampleGoRound) {
  ExamplePair pair{std::nullopt, with_length_parameter(circle({0, 0}, 40, 120))};
  pair.features = {{"pressure", FeatureKind::kNumber}};
  pair.filtered.channels.resize(1);
  for (const double t : pair.filtered.t) pair.filtered.channels[0].push_back(t * (1 - t));
  const Example example({&pair, 1}, {});
  const ExampleLine& line = example.lines()[0];
  ASSERT_TRUE(line.goes_round());
  for (const double length : {1.0, 100.0, line.length() - 1}) {
    for (const double turn : {-1.0, 1.0, 2.0}) {
      EXPECT_NEAR(line.lane(0).features_at(length + turn * line.length())[0],
                  line.lane(0).features_at(length)[0], 1e-9);
    }
  }
  EXPECT_GT(line.lane(0).features_at(1.5 * line.length())[0], 0.2);
}

}  // namespace
}  // namespace libstyle
