// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/jump_costs.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/curves.h"

namespace libstyle {
namespace {

ExamplePair wave_pair(double length, double phase = 0) {
  ExamplePair pair;
  Polyline wave;
  for (double x = 0; x <= length; x += 0.25) {
    wave.points.push_back({x, 5 * std::sin(2 * std::numbers::pi * x / 20 + phase)});
  }
  pair.filtered = with_length_parameter(wave);
  pair.unfiltered = SampledCurve{Polyline{{{0, 0}, {length, 0}}, false}, {0, 1}, {}};
  return pair;
}

TEST(JumpCosts, FindThePhaseOfAWave) {
  const ExamplePair pair = wave_pair(400);
  const Example example({&pair, 1}, {});
  const JumpCosts costs(example);
  std::vector<double> row(example.state_count());
  const auto whole_wave = static_cast<std::size_t>(std::lround(20 / example.step()));
  const std::size_t from = example.state_count() / 2;
  costs.from_start_of(from, row);
  EXPECT_EQ(row[from], 0);
  EXPECT_LT(row[from - whole_wave], 1);
  EXPECT_GT(row[from - whole_wave / 2], 25);
}

TEST(JumpCosts, EndsAreComparedByWhatIsThere) {
  const ExamplePair pair = wave_pair(400);
  const Example example({&pair, 1}, {});
  const JumpCosts costs(example);
  std::vector<double> row(example.state_count());
  costs.from_end_of(example.state_count() - 1, row);
  // The end of the wave has the phase of the places whole waves before it.
  const auto best = std::ranges::min_element(row.begin(), row.end() - 10) - row.begin();
  const double waves = (400 - example.length_of(static_cast<std::size_t>(best))) / 20;
  EXPECT_NEAR(waves, std::round(waves), 0.1);
}

TEST(JumpCosts, WidthsThatDifferCostAsMuchAsTheySpread) {
  ExamplePair pair = wave_pair(400);
  pair.features = {{"width", FeatureKind::kLength}};
  std::vector<double>& widths = pair.filtered.channels.emplace_back();
  // Whole waves in turn thin and thick.
  for (const Point p : pair.filtered.polyline.points) {
    widths.push_back(3 + std::sin(2 * std::numbers::pi * p.x / 40));
  }
  const auto costs_of = [](const ExamplePair& from_pair, int waves) {
    const Example example({&from_pair, 1}, {});
    std::vector<double> row(example.state_count());
    JumpCosts(example).from_start_of(example.state_count() / 2, row);
    const auto steps = static_cast<std::size_t>(std::lround(20 * waves / example.step()));
    return row[example.state_count() / 2 - steps];
  };
  EXPECT_GT(costs_of(pair, 1), 5 * costs_of(pair, 2));
  const double thin = costs_of(pair, 1);
  for (double& width : widths) width = 100 * width + 7;
  EXPECT_NEAR(costs_of(pair, 1), thin, 1e-6 * thin);
  for (double& width : widths) width = 5;
  EXPECT_LT(costs_of(pair, 1), 1);
}

TEST(JumpModel, EveryRowIsADistribution) {
  const ExamplePair pairs[] = {wave_pair(300), wave_pair(160, 1)};
  const Example example(pairs, {});
  const ChainModel chain = make_jump_model(example, 8, false).chain;
  ASSERT_EQ(chain.state_count(), example.state_count());
  for (ChainState j = 0; j < chain.state_count(); ++j) {
    double sum = 0;
    for (ChainState k = 0; k < chain.state_count(); ++k) {
      sum += transition_probability(chain, j, k);
    }
    EXPECT_NEAR(sum, 1, 1e-9);
    EXPECT_GT(chain.rows[j].anywhere, 0);
    EXPECT_EQ(chain.rows[j].coherent > 0, example.has_next(j));
  }
}

TEST(JumpModel, NoJumpGoesNearbyOrIntoTheLastFeatures) {
  const ExamplePair pair = wave_pair(400);
  const Example example({&pair, 1}, {});
  const ChainModel chain = make_jump_model(example, 8, false).chain;
  const double apart = 2 * example.feature_along() - example.step() / 2;
  std::size_t jumps = 0;
  for (ChainState j = 0; j < chain.state_count(); ++j) {
    for (const ChainJump& jump : chain.rows[j].jumps) {
      ++jumps;
      EXPECT_GE(400 - example.length_of(jump.target), apart);
      EXPECT_GE(std::abs(example.length_of(jump.target) - example.length_of(j) - example.step()),
                apart);
    }
  }
  EXPECT_GT(jumps, chain.state_count());
}

TEST(JumpModel, MeanRunIsWhatWasAskedFor) {
  const ExamplePair pair = wave_pair(1200);
  const Example example({&pair, 1}, {});
  const ChainModel chain = make_jump_model(example, 8, false).chain;
  double leave = 0;
  for (const ChainRow& row : chain.rows) leave += 1 - row.coherent;
  leave /= static_cast<double>(chain.state_count());
  const double mean_run = example.step() / leave / example.feature_along();
  EXPECT_NEAR(mean_run, 8, 1.5);
}

TEST(JumpModel, AnExampleWithoutItsLikeOnlyGoesOn) {
  // A single bump on a short line: there is nothing to jump to before the end.
  ExamplePair pair;
  pair.filtered = with_length_parameter(polyline("0 0, 10 0, 13 9, 16 0, 26 0"));
  pair.unfiltered = with_length_parameter(polyline("0 0, 26 0"));
  const Example example({&pair, 1}, {});
  const ChainModel chain = make_jump_model(example, 8, false).chain;
  EXPECT_GT(std::ranges::count(chain.landing, 1), 0);
}

}  // namespace
}  // namespace libstyle
