// SPDX-License-Identifier: Apache-2.0
// Against enumeration of all walks of a tiny chain.
#include "libstyle/analogy/living_walk.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "tests/support/seeds.h"

namespace libstyle {
namespace {

using Walk = std::vector<ChainState>;

constexpr std::size_t kStates = 3;
constexpr std::size_t kSteps = 5;

// Every step is possible, and none as likely as another.
ChainModel random_chain(RandomValues& random) {
  ChainModel model;
  for (ChainState j = 0; j < kStates; ++j) {
    ChainRow row;
    row.coherent = j + 1 < kStates ? random.uniform(0.2, 0.6) : 0;
    row.jumps = {{(j + 2) % 3, random.uniform(0.1, 0.3)}};
    row.anywhere = 1 - row.coherent - row.jumps[0].probability;
    model.rows.push_back(row);
    model.landing.push_back(1);
  }
  return model;
}

ChainTask task_with_costs(RandomValues& random) {
  std::vector<double> table(kSteps * kStates);
  for (double& cost : table) cost = random.uniform(0, 2);
  ChainTask task;
  task.steps = kSteps;
  task.costs = [table](std::size_t step, std::span<double> costs) {
    for (std::size_t j = 0; j < kStates; ++j) costs[j] += table[step * kStates + j];
    return true;
  };
  return task;
}

std::map<Walk, double> distribution(const ChainModel& model, const ChainTask& task, bool closed) {
  std::map<Walk, double> shares;
  double total = 0;
  for (std::size_t code = 0; code < 243; ++code) {
    Walk walk;
    double weight = 1;
    for (std::size_t step = 0, rest = code; step < kSteps; ++step, rest /= kStates) {
      walk.push_back(static_cast<ChainState>(rest % kStates));
      std::vector<double> costs(kStates, 0.0);
      task.costs(step, costs);
      weight *= std::exp(-costs[walk.back()]);
      if (step > 0) weight *= transition_probability(model, walk[step - 1], walk[step]);
    }
    if (closed) weight *= transition_probability(model, walk.back(), walk.front());
    shares[walk] = weight;
    total += weight;
  }
  for (auto& [walk, share] : shares) share /= total;
  return shares;
}

// A walk drawn from the shares.
Walk draw(const std::map<Walk, double>& shares, double at) {
  for (const auto& [walk, share] : shares) {
    if (at < share) return walk;
    at -= share;
  }
  return shares.rbegin()->first;
}

TEST(LivingWalk, KeepsTheDistributionOfTheChain) {
  for (const bool closed : {false, true}) {
    RandomValues random(7);
    const ChainModel model = random_chain(random);
    const ChainTask task = task_with_costs(random);
    const std::map<Walk, double> shares = distribution(model, task, closed);
    constexpr int kDraws = 30000;
    std::map<Walk, int> counts;
    const WalkChange change{.share = 0.7, .piece = 2, .closed = closed};
    for (int i = 0; i < kDraws; ++i) {
      const RandomStream stream(5, static_cast<std::uint64_t>(i));
      const Walk before = draw(shares, random.uniform(0, 1));
      ++counts[changed_walk(model, task, before, change, stream, 0)];
    }
    for (const auto& [walk, share] : shares) {
      const double expected = kDraws * share;
      EXPECT_NEAR(counts[walk], expected, 5 * std::sqrt(expected) + 3);
    }
  }
}

TEST(LivingWalk, ChangesAboutTheShareOfPieces) {
  RandomValues random(3);
  const ChainModel model = random_chain(random);
  ChainTask task;
  task.steps = 40000;
  const Walk walk = sample_chain(model, task, RandomStream(1, 0));
  const auto changed = [&](double share) {
    const WalkChange change{.share = share, .piece = 20};
    const Walk after = changed_walk(model, task, walk, change, RandomStream(2, 0), 0);
    double count = 0;
    for (std::size_t i = 0; i < walk.size(); ++i) count += after[i] != walk[i];
    return count;
  };
  EXPECT_EQ(changed(0), 0);
  EXPECT_NEAR(changed(0.25) / changed(1), 0.25, 0.04);
  EXPECT_NEAR(changed(0.5) / changed(1), 0.5, 0.04);
}

// One long example, left now and then for a place a little on.
ChainModel long_chain(std::size_t states) {
  ChainModel model;
  for (std::size_t j = 0; j < states; ++j) {
    const bool ends = j + 1 == states;
    ChainRow row;
    row.jumps = {{static_cast<ChainState>((j * 7 + 3) % states), ends ? 0.999 : 0.02}};
    row.anywhere = 0.001;
    row.coherent = ends ? 0 : 0.979;
    model.rows.push_back(row);
    model.landing.push_back(1);
  }
  return model;
}

TEST(LivingWalk, NoRunGetsLongerThanAllowed) {
  const ChainModel model = long_chain(200);
  ChainTask task;
  task.steps = 600;
  const ChainVariety variety{.longest_run = 40, .repeat_factor = 0.25};
  for_each_seed(10, [&](std::uint64_t seed) {
    Walk walk = sample_chain(model, task, RandomStream(seed, 0), 0, variety);
    for (std::uint64_t frame = 1; frame < 10; ++frame) {
      const WalkChange change{.share = 0.5, .piece = 30, .closed = false, .variety = variety};
      walk = changed_walk(model, task, walk, change, RandomStream(seed + frame, 0), 0);
      std::size_t run = 1;
      for (std::size_t i = 1; i < walk.size(); ++i) {
        run = walk[i] == walk[i - 1] + 1 ? run + 1 : 1;
        EXPECT_LE(run, 40u);
      }
    }
  });
}

}  // namespace
}  // namespace libstyle
