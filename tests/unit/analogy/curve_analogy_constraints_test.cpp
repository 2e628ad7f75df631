// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/rigid_alignment.h"
#include "libstyle/geometry/segment_grid.h"
#include "libstyle/geometry/turning_statistics.h"
#include "tests/support/analogy_examples.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

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

}  // namespace
}  // namespace libstyle
