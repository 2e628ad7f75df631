// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/jump_model.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "tests/support/analogy_examples.h"
#include "tests/support/curves.h"

namespace libstyle {
namespace {

TEST(JumpModel, EveryRowIsADistribution) {
  const ExamplePair pairs[] = {wave_pair(300), wave_pair(160, 1)};
  const Example example(pairs, {});
  const ChainModel chain = make_jump_model(example, {}).chain;
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
  const ChainModel chain = make_jump_model(example, {}).chain;
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
  const ChainModel chain = make_jump_model(example, {}).chain;
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
  const ChainModel chain = make_jump_model(example, {}).chain;
  EXPECT_GT(std::ranges::count(chain.landing, 1), 0);
}

}  // namespace
}  // namespace libstyle
