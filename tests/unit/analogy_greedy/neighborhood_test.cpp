// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/neighborhood.h"

#include <gtest/gtest.h>

#include <numeric>

#include "libstyle/analogy/greedy/matching.h"
#include "tests/bench/literal/neighborhood.h"
#include "tests/support/matchers.h"
#include "tests/unit/analogy_greedy/curves.h"

namespace libstyle {
namespace {

constexpr std::size_t kSize = 21;

NeighborhoodShape shape_of(double spacing) { return {binomial_weights(31, kSize), spacing}; }

// Both kinds hold the same samples at the same places.
void expect_equal(const NeighborhoodView& view, const literal::Neighborhood& expected) {
  for (std::size_t k = 0; k < kSize; ++k) {
    ASSERT_EQ(view.begin <= k && k < view.end, expected[k].has_value()) << "sample " << k;
    if (!expected[k]) continue;
    EXPECT_THAT(view.origin + view.positions[k], PointNear(*expected[k], 1e-11));
    if (k == view.begin) continue;
    EXPECT_THAT(view.tangents[k], PointNear(normalized(*expected[k] - *expected[k - 1]), 1e-10));
  }
}

TEST(BinomialWeights, AreSymmetricAroundOne) {
  const std::vector<double> weights = binomial_weights(101, 33);
  EXPECT_EQ(weights[16], 1);
  for (std::size_t k = 0; k < 33; ++k) EXPECT_EQ(weights[k], weights[32 - k]);
}

// Of all samples: the variance of a binomial distribution, (n - 1) / 4.
TEST(BinomialWeights, SpreadAsTheOrderSays) {
  const std::vector<double> weights = binomial_weights(101, 101);
  double total = 0, second = 0;
  for (std::size_t k = 0; k < 101; ++k) {
    const double off = static_cast<double>(k) - 50;
    total += weights[k];
    second += weights[k] * off * off;
  }
  EXPECT_NEAR(second / total, 25, 1e-9);
}

TEST(BinomialWeights, LoseLittleOfTheWeightWhenCutOff) {
  const std::vector<double> all = binomial_weights(101, 101), some = binomial_weights(101, 33);
  const double total = std::accumulate(all.begin(), all.end(), 0.0);
  EXPECT_LT(1 - std::accumulate(some.begin(), some.end(), 0.0) / total, 2e-3);
}

TEST(Neighborhood, IsThatOfTheListings) {
  for_each_seed(20, [](std::uint64_t seed) {
    RandomValues random(seed);
    const Polyline curve = seed % 2 == 0 ? random_stroke(random, 30) : random_blob(random, 30);
    const ArcLength along(curve);
    const NeighborhoodShape shape = shape_of(along.total() / 35);
    Neighborhood neighborhood(kSize);
    for (int i = 0; i < 20; ++i) {
      const double center = random.uniform(0, along.total());
      neighborhood.sample(curve, along.place_at(center), shape);
      expect_equal(neighborhood.view(),
                   literal::sample_neighborhood(along, center, shape.spacing(), kSize));
    }
  });
}

TEST(Neighborhood, GoesRoundAClosedCurveMoreThanOnce) {
  const ArcLength along(circle({}, 1, 40));
  const NeighborhoodShape shape = shape_of(along.total() / 4);
  Neighborhood neighborhood(kSize);
  neighborhood.sample(along.polyline(), {0, 0}, shape);
  EXPECT_EQ(neighborhood.view().end, kSize);
  for (std::size_t k = 2; k < kSize; k += 4) {
    EXPECT_THAT(neighborhood.view().positions[k], PointNear({0, 0}, 1e-9));
  }
}

TEST(Neighborhood, BeyondTheEndHasTheSamplesBeforeIt) {
  RandomValues random(5);
  const Polyline curve = random_stroke(random, 30);
  const ArcLength along(curve);
  const NeighborhoodShape shape = shape_of(0.7);
  Neighborhood neighborhood(kSize);
  for (const double gap : {0.7, 1.4, 1.7, 6.9, 7.0, 7.1}) {
    neighborhood.sample_beyond_end(curve, gap, shape);
    const NeighborhoodView view = neighborhood.view();
    const literal::Neighborhood expected =
        literal::sample_neighborhood(along, along.total() + gap, shape.spacing(), kSize);
    if (view.empty()) {
      for (const auto& sample : expected) EXPECT_FALSE(sample);
    } else {
      expect_equal(view, expected);
    }
  }
}

TEST(Neighborhood, OfACurveWithOnePointIsThatPointOrNothing) {
  Neighborhood neighborhood(kSize);
  neighborhood.sample_beyond_end(polyline("3 4"), 2, shape_of(1));
  EXPECT_EQ(neighborhood.view().begin, kSize / 2 - 2);
  EXPECT_EQ(neighborhood.view().end, kSize / 2 - 1);
  neighborhood.sample_beyond_end(polyline("3 4"), 2.5, shape_of(1));
  EXPECT_TRUE(neighborhood.view().empty());
  neighborhood.sample_beyond_end({}, 1, shape_of(1));
  EXPECT_TRUE(neighborhood.view().empty());
}

TEST(Neighborhood, ReversedIsThatOfTheReversedCurve) {
  RandomValues random(6);
  Polyline curve = random_stroke(random, 40);
  const NeighborhoodShape shape = shape_of(0.5);
  Neighborhood there(kSize), back(kSize);
  there.sample_beyond_end(curve, 1, shape);
  there.reverse(shape);
  std::ranges::reverse(curve.points);
  EXPECT_EQ(there.view().begin, kSize / 2 + 2);
  // From one gap before the first point of the reversed curve.
  const ArcLength along(curve);
  const auto expected = literal::sample_neighborhood(along, -1, 0.5, kSize);
  expect_equal(there.view(), expected);
}

TEST(Matching, AgreesWithTheListings) {
  for_each_seed(30, [](std::uint64_t seed) {
    RandomValues random(seed);
    const ArcLength a(random_stroke(random, 30)), b(random_stroke(random, 30));
    const NeighborhoodShape shape = shape_of(1);
    const double in_a = random.uniform(6, a.total()), in_b = random.uniform(6, b.total() - 6);
    Neighborhood from(kSize), to(kSize);
    from.sample(a.polyline(), a.place_at(in_a), shape);
    to.sample(b.polyline(), b.place_at(in_b), shape, false);
    const literal::Neighborhood slow_from = literal::sample_neighborhood(a, in_a, 1, kSize);
    literal::Neighborhood slow_to = literal::sample_neighborhood(b, in_b, 1, kSize);
    slow_to[kSize / 2].reset();
    const std::vector<double> weights = binomial_weights(31, kSize);
    const auto expected = literal::compare(slow_from, slow_to, weights, 100);
    const Match found = match(from.view(), to.view(), shape, 100);
    EXPECT_NEAR(found.overlap, expected.overlap, 1e-12);
    EXPECT_NEAR(found.twist.x, expected.twist.real(), 1e-9);
    EXPECT_NEAR(found.twist.y, expected.twist.imag(), 1e-9);
    const Vector rotation = best_rotation(found.twist, true);
    const double distance = shape_distance(from.view(), to.view(), found, rotation, shape, 100);
    EXPECT_NEAR(distance,
                literal::shape_distance(slow_from, slow_to, expected, {rotation.x, rotation.y},
                                        weights, 100),
                1e-9);
    EXPECT_NEAR(found.distance_for(rotation), distance, 1e-9);
  });
}

TEST(Matching, HasNoRotationWhereNoneIsBetter) {
  EXPECT_EQ(best_rotation({0, 0}, true), (Vector{1, 0}));
  EXPECT_EQ(best_rotation({0, 5}, true), (Vector{0, 1}));
  EXPECT_EQ(best_rotation({0, 5}, false), (Vector{1, 0}));
}

}  // namespace
}  // namespace libstyle
