// SPDX-License-Identifier: Apache-2.0
// Against enumeration of all walks of tiny chains.
#include "libstyle/analogy/chain.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/support/seeds.h"

namespace libstyle {
namespace {

using Walk = std::vector<ChainState>;

constexpr std::size_t kStates = 4;

// A random chain with a break in the middle, some jumps, and a state where no jump lands.
ChainModel random_chain(RandomValues& random) {
  ChainModel model;
  for (ChainState j = 0; j < kStates; ++j) {
    ChainRow row;
    const bool ends = j == 1 || j + 1 == kStates;
    const ChainState target = (j + 2) % kStates;
    const double leave = ends ? random.uniform(0.5, 0.9) : random.uniform(0.1, 0.5);
    row.jumps = {{target, leave}};
    row.anywhere = ends ? 1 - leave : 0.05;
    row.coherent = ends ? 0 : 1 - leave - row.anywhere;
    model.rows.push_back(row);
    model.landing.push_back(j != 3);
  }
  return model;
}

StepCosts random_costs(RandomValues& random, std::size_t steps) {
  std::vector<double> table(steps * kStates);
  for (double& cost : table) cost = random.uniform(0, 3);
  return [table](std::size_t step, std::span<double> costs) {
    for (std::size_t j = 0; j < kStates; ++j) costs[j] += table[step * kStates + j];
    return true;
  };
}

// The weight of every walk that the task allows.
std::map<Walk, double> enumerate(const ChainModel& model, const ChainTask& task) {
  std::map<Walk, double> weights;
  const auto count = static_cast<std::size_t>(std::pow(kStates, task.steps));
  for (std::size_t code = 0; code < count; ++code) {
    Walk walk;
    double weight = 1;
    for (std::size_t step = 0, rest = code; step < task.steps; ++step, rest /= kStates) {
      walk.push_back(static_cast<ChainState>(rest % kStates));
      std::vector<double> costs(kStates, 0.0);
      if (task.costs) task.costs(step, costs);
      weight *= std::exp(-costs[walk.back()]);
      if (step > 0) weight *= transition_probability(model, walk[step - 1], walk[step]);
    }
    if (task.origin && walk.front() != *task.origin) continue;
    if (task.next) weight *= transition_probability(model, walk.back(), *task.next);
    if (weight > 0) weights[walk] = weight;
  }
  return weights;
}

ChainState random_state(RandomValues& random) {
  return static_cast<ChainState>(random.below(kStates));
}

ChainTask random_task(RandomValues& random, std::uint64_t kind) {
  ChainTask task;
  task.steps = 4;
  if (kind % 2 == 1) task.costs = random_costs(random, task.steps);
  if (kind % 3 > 0) task.origin = random_state(random);
  if (kind % 3 == 2) task.next = random.chance(0.5) ? *task.origin : random_state(random);
  return task;
}

TEST(Chain, RowsOfTransitionProbabilitiesSumToOne) {
  RandomValues random(5);
  const ChainModel model = random_chain(random);
  for (ChainState j = 0; j < kStates; ++j) {
    double sum = 0;
    for (ChainState k = 0; k < kStates; ++k) sum += transition_probability(model, j, k);
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(Chain, SamplesWalksWithTheirExactProbability) {
  for_each_seed(6, [](std::uint64_t seed) {
    RandomValues random(seed);
    const ChainModel model = random_chain(random);
    const ChainTask task = random_task(random, seed);
    const std::map<Walk, double> weights = enumerate(model, task);
    double total = 0;
    for (const auto& [walk, weight] : weights) total += weight;

    constexpr int kDraws = 20000;
    std::map<Walk, int> counts;
    for (int draw = 0; draw < kDraws; ++draw) {
      ++counts[sample_chain(model, task, RandomStream(seed, static_cast<std::uint64_t>(draw)))];
    }
    for (const auto& [walk, count] : counts) EXPECT_TRUE(weights.contains(walk));
    for (const auto& [walk, weight] : weights) {
      const double expected = kDraws * weight / total;
      EXPECT_NEAR(counts[walk], expected, 5 * std::sqrt(expected) + 3);
    }
  });
}

TEST(Chain, FindsTheMostProbableWalk) {
  for_each_seed(60, [](std::uint64_t seed) {
    RandomValues random(seed);
    const ChainModel model = random_chain(random);
    const ChainTask task = random_task(random, seed);
    const std::map<Walk, double> weights = enumerate(model, task);
    double most = 0;
    for (const auto& [walk, weight] : weights) most = std::max(most, weight);
    EXPECT_NEAR(weights.at(best_chain(model, task)), most, 1e-12 * most);
  });
}

TEST(Chain, SamplesTheSameWalkForTheSameStream) {
  RandomValues random(1);
  const ChainModel model = random_chain(random);
  const ChainTask task{500, {}, {}, {}};
  const RandomStream stream(7, 3);
  EXPECT_EQ(sample_chain(model, task, stream, 40), sample_chain(model, task, stream, 40));
  EXPECT_NE(sample_chain(model, task, stream, 40), sample_chain(model, task, stream, 41));
}

// A chain that mostly goes on, round a ring by a jump at its end.
ChainModel long_chain(std::size_t states) {
  ChainModel model;
  for (std::size_t j = 0; j < states; ++j) {
    const bool ends = j + 1 == states;
    const auto target = static_cast<ChainState>((j * 7 + 3) % states);
    const bool jumps = target != j + 1;
    ChainRow row;
    if (jumps) row.jumps = {{target, ends ? 0.999 : 0.01}};
    row.anywhere = 0.001;
    row.coherent = ends ? 0 : jumps ? 0.989 : 0.999;
    model.rows.push_back(row);
    model.landing.push_back(1);
  }
  return model;
}

std::size_t longest_run(const Walk& walk) {
  std::size_t longest = 1, run = 1;
  for (std::size_t i = 1; i < walk.size(); ++i) {
    run = walk[i] == walk[i - 1] + 1 ? run + 1 : 1;
    longest = std::max(longest, run);
  }
  return longest;
}

TEST(ChainVariety, NoRunIsLongerThanAllowed) {
  const ChainModel model = long_chain(200);
  ChainTask task;
  task.steps = 1000;
  for_each_seed(20, [&](std::uint64_t seed) {
    const RandomStream random(seed, 0);
    EXPECT_GT(longest_run(sample_chain(model, task, random)), 40u);
    EXPECT_LE(longest_run(sample_chain(model, task, random, 0, {40, 1})), 40u);
  });
}

TEST(ChainVariety, RepeatsGetRarer) {
  const ChainModel model = long_chain(200);
  ChainTask task;
  task.steps = 400;
  double used_anyhow = 0, used_gladly = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const RandomStream random(seed, 0);
    const Walk plain = sample_chain(model, task, random, 0, {40, 1});
    const Walk varied = sample_chain(model, task, random, 0, {40, 0.01});
    used_anyhow += static_cast<double>(std::set(plain.begin(), plain.end()).size());
    used_gladly += static_cast<double>(std::set(varied.begin(), varied.end()).size());
  }
  EXPECT_GT(used_gladly, 1.05 * used_anyhow);
}

TEST(ChainVariety, StillReturnsToTheOrigin) {
  const ChainModel model = long_chain(30);
  ChainTask task;
  task.steps = 50;
  task.origin = 4;
  task.next = task.origin;
  for_each_seed(20, [&](std::uint64_t seed) {
    const Walk walk = sample_chain(model, task, RandomStream(seed, 0), 0, {10, 0.1});
    EXPECT_EQ(walk.front(), 4u);
    EXPECT_GT(transition_probability(model, walk.back(), 4), 0);
  });
}

TEST(Chain, LongWalksDoNotUnderflow) {
  RandomValues random(2);
  const ChainModel model = random_chain(random);
  ChainTask task;
  task.steps = 20000;
  task.costs = [](std::size_t, std::span<double> costs) {
    for (std::size_t j = 0; j < costs.size(); ++j) costs[j] += 1000 + static_cast<double>(j);
    return true;
  };
  EXPECT_EQ(sample_chain(model, task, RandomStream(1, 1)).size(), task.steps);
  EXPECT_EQ(best_chain(model, task).size(), task.steps);
}

TEST(Chain, ReturnsEvenWhereNoJumpLeadsBack) {
  // Nothing but the last, tiny probability leads back to the origin.
  ChainModel model;
  for (int j = 0; j < 3; ++j) model.rows.push_back({j < 2 ? 1 - 1e-9 : 0, j < 2 ? 1e-9 : 1, {}});
  model.landing = {1, 1, 1};
  const ChainTask task{5, {}, ChainState{1}, true};
  const Walk walk = sample_chain(model, task, RandomStream(1, 1));
  EXPECT_EQ(walk.front(), 1u);
  EXPECT_GT(transition_probability(model, walk.back(), walk.front()), 0);
}

}  // namespace
}  // namespace libstyle
