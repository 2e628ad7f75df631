// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/level_search.h"

#include <gtest/gtest.h>

#include "libstyle/analogy/greedy/greedy_search.h"
#include "tests/bench/literal/literal_search.h"
#include "tests/support/matchers.h"
#include "tests/unit/analogy_greedy/curves.h"

namespace libstyle {
namespace {

SearchParameters small_paper_parameters() {
  SearchParameters p = paper_parameters();
  p.levels = 3;
  p.binomial_order = 21;
  p.neighborhood_samples = 21;
  p.coarsest_passes = 1;
  return p;
}

// ---- Against the listings
// ------------------------------------------------------------------------

// The same choices and the same curve, vertex by vertex.
void expect_equal(const SearchedCurve& fast, const literal::CopiedCurve& slow,
                  const SampledCurve& filtered) {
  const SampledCurve example = resample(filtered, kFinestSpacing);
  const std::vector<double> lengths = cumulative_lengths(example.polyline);
  ASSERT_EQ(fast.curve.size(), slow.curve.size());
  for (std::size_t i = 0; i < fast.curve.size(); ++i) {
    EXPECT_NEAR(fast.sources[i].length, lengths[slow.sources[i]], 1e-9) << "vertex " << i;
    EXPECT_THAT(fast.curve.polyline.points[i], PointNear(slow.curve.polyline.points[i], 1e-9))
        << "vertex " << i;
  }
}

TEST(FaithfulSearch, DrawsWhatTheListingsDraw) {
  for_each_seed(3, [](std::uint64_t seed) {
    SearchParameters p = small_paper_parameters();
    p.seed = seed;
    p.rotate = seed % 2 == 0;
    p.shape_weight = seed == 2 ? 2 : 0;
    const SampledCurve a = straight(40), a_filtered = wave(40, 12, 2), b = wave(15, 60, 4);
    const CurveConstraint constraints[] = {{0, {0, 1}, {}}, {0.4, {6, 4}, 2.0}};
    const SearchExample example{a, a_filtered};
    expect_equal(GreedySearch({&example, 1}, p).draw(b, constraints),
                 literal::synthesize_analogy_multires(a, a_filtered, b, constraints, p),
                 a_filtered);
  });
}

TEST(FaithfulSearch, DrawsClosedCurvesAsTheListingsDo) {
  const SearchParameters p = small_paper_parameters();
  const SampledCurve a = straight(40), a_filtered = wave(40, 12, 2);
  const SampledCurve b = with_length_parameter(circle({}, 3, 60));
  const SearchExample example{a, a_filtered};
  expect_equal(GreedySearch({&example, 1}, p).draw(b),
               literal::synthesize_analogy_multires(a, a_filtered, b, {}, p), a_filtered);
}

TEST(FaithfulSearch, MakesWhatTheListingsMake) {
  for_each_seed(2, [](std::uint64_t seed) {
    SearchParameters p = small_paper_parameters();
    p.seed = seed;
    p.rotate = seed % 2 == 0;
    const SampledCurve a_filtered = wave(40, 12, 2);
    const SearchExample example{std::nullopt, a_filtered};
    expect_equal(GreedySearch({&example, 1}, p).synthesize(25),
                 literal::synthesize_curve_multires(a_filtered, 25, p), a_filtered);
  });
}

// ---- One level
// -----------------------------------------------------------------------------------

struct OneLevel {
  SearchParameters p;
  SampledCurve a = resample(straight(60), kFinestSpacing);
  SampledCurve a_filtered = resample(wave(60, 12, 2), kFinestSpacing);
  LevelExample example;

  explicit OneLevel(const SearchParameters& parameters)
      : p(parameters), example({{a_filtered, {a}}}, {p.shape_weight}, kFinestSpacing, false, p) {}

  LevelSearch search(const SampledCurve& b, std::vector<CurveConstraint> constraints = {}) const {
    return {example, {{b}, std::move(constraints), p.offset_weight, 0}, p};
  }
};

// Without the coherence factor each choice is the best there is for its vertex, what there was
// before included.
TEST(LevelSearch, NeverRaisesTheCostOfAVertexItChooses) {
  SearchParameters p;
  p.coherence = 0;
  p.binomial_order = p.neighborhood_samples = 21;
  const OneLevel level(p);
  const SampledCurve b = resample(wave(30, 60, 4), kFinestSpacing);
  for_each_seed(3, [&](std::uint64_t seed) {
    LevelSearch search = level.search(b, {{0.5, {15, 3}, 1.0}});
    DrawnLevel drawn = search.grow_along_target(pass_random(seed, 0, 0, 0));
    RandomValues random(seed);
    drawn.curve.polyline = with_noise(drawn.curve.polyline, random, 0.3);
    // Backwards the last vertex is chosen first, forwards the first: all others are as they were.
    for (const bool backward : {false, true}) {
      DrawnLevel refined = drawn;
      search.refine(refined, backward, pass_random(seed, 0, 0, 1));
      const std::size_t i = backward ? drawn.curve.size() - 1 : 0;
      DrawnLevel changed = drawn;
      changed.curve.polyline.points[i] = refined.curve.polyline.points[i];
      changed.sources[i] = refined.sources[i];
      EXPECT_LE(search.cost_of(changed, i), search.cost_of(drawn, i) + 1e-9);
    }
  });
}

TEST(LevelSearch, DoesNotJumpToWhereTheExampleEndsSoon) {
  SearchParameters p;
  p.binomial_order = p.neighborhood_samples = 21;
  const OneLevel level(p);
  const double end = level.example.length() - level.example.shape().half_width();
  for_each_seed(5, [&](std::uint64_t seed) {
    LevelSearch search = level.search(resample(straight(50), kFinestSpacing));
    const DrawnLevel drawn = search.grow_along_target(pass_random(seed, 0, 0, 0));
    for (std::size_t i = 1; i < drawn.curve.size(); ++i) {
      if (drawn.curve.t[i] > 0.9) break;
      const double length = level.example.length_of(drawn.sources[i]);
      const double step = length - level.example.length_of(drawn.sources[i - 1]);
      EXPECT_TRUE(length < end || (step > 0 && step < 4)) << "vertex " << i;
    }
  });
}

TEST(LevelExample, KnowsWhichPlacesFollowEachOther) {
  SearchParameters p;
  p.binomial_order = p.neighborhood_samples = 21;
  const SampledCurve open = resample(wave(60, 12, 2), 0.5);
  const SampledCurve ring = resample(with_length_parameter(circle({}, 8, 200)), 0.5);
  const LevelExample example({{open, {}}, {ring, {}}}, {}, 0.5, false, p);
  EXPECT_NEAR(*example.length_between(3, 5), 1, 0.05);
  EXPECT_NEAR(*example.length_between(5, 3), -1, 0.05);
  EXPECT_FALSE(example.length_between(open.size() - 1, open.size()));
  const std::size_t last = example.size() - 1;
  EXPECT_NEAR(*example.length_between(last, open.size()), 0.5, 0.05);
  EXPECT_TRUE(example.is_near_end(open.size() - 2, false));
  EXPECT_FALSE(example.is_near_end(open.size() - 2, true));
  EXPECT_TRUE(example.is_near_end(2, true));
  EXPECT_FALSE(example.is_near_end(last, false));
  EXPECT_EQ(example.place_near(0, 1e9), open.size() - 1);
  EXPECT_EQ(example.place_near(1, 2 * std::numbers::pi * 8 - 0.01), open.size());
}

// Every place of a straight line is like every other; no place of noise is like another.
TEST(LevelExample, HasAFloorThatTellsAlikeFromUnlike) {
  SearchParameters p;
  p.binomial_order = p.neighborhood_samples = 21;
  RandomValues random(1);
  const LevelExample same({{resample(straight(60), 0.5), {}}}, {}, 0.5, true, p);
  const LevelExample unlike(
      {{resample(with_length_parameter(random_scribble(random, 150, 2)), 0.5), {}}}, {}, 0.5, true,
      p);
  EXPECT_NEAR(same.floor(), 0, 1e-6);
  EXPECT_GT(unlike.floor(), 1);
}

}  // namespace
}  // namespace libstyle
