// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/literal/literal_search.h"

#include <gtest/gtest.h>

#include <limits>

#include "libstyle/base/error.h"
#include "tests/bench/literal/neighborhood.h"
#include "tests/support/matchers.h"
#include "tests/unit/analogy_greedy/curves.h"

namespace libstyle::literal {
namespace {

// Few and small: the listings are slow.
SearchParameters small_parameters() {
  SearchParameters p = paper_parameters();
  p.levels = 3;
  p.binomial_order = 21;
  p.neighborhood_samples = 21;
  p.coarsest_passes = 1;
  return p;
}

TEST(LiteralWeights, AreBinomialAndSymmetric) {
  const std::vector<double> weights = binomial_weights(5, 5);
  EXPECT_THAT(weights, testing::ElementsAre(1.0 / 6, 4.0 / 6, 1, 4.0 / 6, 1.0 / 6));
  EXPECT_EQ(binomial_weights(101, 101).front(), binomial_weights(101, 101).back());
  EXPECT_GT(binomial_weights(101, 101).front(), 0);
}

TEST(LiteralNeighborhood, HasSamplesAtEvenArcDistances) {
  const ArcLength corner(polyline("0 0, 2 0, 2 2"));
  const Neighborhood samples = sample_neighborhood(corner, 2, 1, 7);
  EXPECT_FALSE(samples[0]);
  EXPECT_EQ(*samples[1], (Point{0, 0}));
  EXPECT_EQ(*samples[3], (Point{2, 0}));
  EXPECT_EQ(*samples[5], (Point{2, 2}));
  EXPECT_FALSE(samples[6]);
}

TEST(LiteralNeighborhood, GoesRoundClosedCurves) {
  const ArcLength square(polyline("0 0, 2 0, 2 2, 0 2 z"));
  const Neighborhood samples = sample_neighborhood(square, 0, 1, 5);
  EXPECT_EQ(*samples[0], (Point{0, 2}));
  EXPECT_EQ(*samples[1], (Point{0, 1}));
  EXPECT_EQ(*samples[4], (Point{2, 0}));
}

// Every rotation by whole degrees is tried.
TEST(LiteralComparison, FindsTheRotationOfLeastDistance) {
  RandomValues random(3);
  const ArcLength a(random_stroke(random, 60)), b(random_stroke(random, 60));
  const std::vector<double> weights = binomial_weights(21, 21);
  const Neighborhood from = sample_neighborhood(a, a.total() / 2, 1, 21);
  const Neighborhood to = sample_neighborhood(b, b.total() / 2, 1, 21);
  const Comparison both = compare(from, to, weights, 7);
  const double least =
      shape_distance(from, to, both, both.twist / std::abs(both.twist), weights, 7);
  for (int degrees = 0; degrees < 360; ++degrees) {
    const auto rotation = std::polar(1.0, degrees * std::numbers::pi / 180);
    EXPECT_LE(least, shape_distance(from, to, both, rotation, weights, 7) + 1e-9);
  }
}

TEST(LiteralComparison, IsZeroForTurnedAndMovedCopies) {
  RandomValues random(4);
  const SampledCurve curve = with_length_parameter(random_stroke(random, 60));
  const ArcLength a(curve.polyline), b(moved(turned(curve, 1), {5, 6}).polyline);
  const std::vector<double> weights = binomial_weights(21, 21);
  const Neighborhood from = sample_neighborhood(a, 20, 1, 21);
  const Neighborhood to = sample_neighborhood(b, 20, 1, 21);
  const Comparison both = compare(from, to, weights, 100);
  EXPECT_NEAR(std::arg(both.twist), 1, 1e-12);
  EXPECT_NEAR(shape_distance(from, to, both, both.twist / std::abs(both.twist), weights, 100), 0,
              1e-18);
}

// A'= A, so B' = B, to within the spacing of the coarsest level.
TEST(LiteralAnalogy, OfNoChangeChangesLittle) {
  const SampledCurve example = wave(60, 20, 3);
  SearchParameters p = small_parameters();
  p.shape_weight = 2;
  const SampledCurve line = moved(wave(40, 20, 3), {7, 9});
  const CopiedCurve drawn = synthesize_analogy_multires(example, example, line, {}, p);
  for (std::size_t i = 0; i < drawn.curve.size(); ++i) {
    EXPECT_THAT(drawn.curve.polyline.points[i],
                PointNear(point_at_parameter(line, drawn.curve.t[i]), 0.72 * 2));
  }
}

TEST(LiteralAnalogy, MovesAlongWithItsInput) {
  const SearchParameters p = small_parameters();
  const SampledCurve a = straight(50), a_filtered = wave(50, 12, 2);
  const SampledCurve b = wave(25, 60, 4);
  const CopiedCurve drawn = synthesize_analogy_multires(a, a_filtered, b, {}, p);
  const CopiedCurve moved_drawn =
      synthesize_analogy_multires(a, a_filtered, moved(b, {11, -5}), {}, p);
  EXPECT_EQ(moved_drawn.sources, drawn.sources);
  EXPECT_LT(greatest_distance(moved_drawn.curve.polyline, moved(drawn.curve, {11, -5}).polyline),
            1e-9);
}

TEST(LiteralAnalogy, MeetsHardConstraints) {
  const SearchParameters p = small_parameters();
  const CurveConstraint ends[] = {{0, {1, 3}, {}}, {1, {24, -2}, {}}};
  const CopiedCurve drawn =
      synthesize_analogy_multires(straight(50), wave(50, 12, 2), straight(25), ends, p);
  EXPECT_EQ(drawn.curve.polyline.points.front(), ends[0].position);
  EXPECT_EQ(drawn.curve.polyline.points.back(), ends[1].position);
}

// The sum over vertices of the least over all places, rotations tried one by one, of the distance
// printed in section 3.1, computed from the points alone.
TEST(LiteralCost, IsWhatSection31Says) {
  SearchParameters p = small_parameters();
  p.rotate = false;
  p.least_overlap = 1;
  Level level;
  level.filtered = resample(wave(40, 12, 2), 0.5);
  const SampledCurve drawn = resample(wave(30, 9, 2), 0.5);
  const std::vector<double> weights = binomial_weights(21, 21);
  const ArcLength a(level.filtered.polyline), b(drawn.polyline);

  double expected = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < level.filtered.size(); ++j) {
      const auto from = sample_neighborhood(a, a.cumulative()[j], 0.125, 21);
      const auto to = sample_neighborhood(b, b.cumulative()[i], 0.125, 21);
      Point mean_from, mean_to;
      double total = 0, sum = 0;
      bool whole = true;
      for (std::size_t k = 0; k < 21; ++k) {
        if (k == 10 || !to[k]) continue;
        whole = whole && from[k].has_value();
        if (!from[k]) continue;
        total += weights[k];
        mean_from += weights[k] * *from[k];
        mean_to += weights[k] * *to[k];
      }
      if (!whole) continue;
      const Vector shift = mean_to / total - mean_from / total;
      for (std::size_t k = 0; k < 21; ++k) {
        if (!to[k] || !from[k]) continue;
        sum += weights[k] * squared_norm(*from[k] + shift - *to[k]);
        if (k == 10 || k == 11 || k == 0 || !to[k - 1] || !from[k - 1]) continue;
        sum += weights[k] * p.tangent_weight *
               squared_norm(normalized(*from[k] - *from[k - 1]) - normalized(*to[k] - *to[k - 1]));
      }
      least = std::min(least, sum);
    }
    expected += least;
  }
  EXPECT_NEAR(curve_cost(level, drawn, p), expected, 1e-9 * expected);
}

TEST(LiteralSynthesis, ReachesTheLengthAskedForAtTheCoarsestLevel) {
  SearchParameters p = small_parameters();
  Level level;
  level.filtered = resample(wave(80, 12, 2), 0.5);
  const CopiedCurve drawn = synthesize_curve(level, 50, p, pass_random(1, 0, 0, 0));
  EXPECT_GE(arc_length(drawn.curve.polyline), 50);
  EXPECT_LT(arc_length(drawn.curve.polyline), 50 + 4);
  EXPECT_EQ(drawn.sources.size(), drawn.curve.size());
}

TEST(LiteralSynthesis, RefusesAnExampleShorterThanThreeNeighborhoods) {
  EXPECT_THROW(synthesize_curve_multires(wave(5, 5, 1), 50, small_parameters()), Error);
}

}  // namespace
}  // namespace libstyle::literal
