// SPDX-License-Identifier: Apache-2.0
// A Markov chain over the pieces of an example, sampled exactly or solved for its best path.
//
// The example is cut into pieces of equal length, the states. A walk that makes a new curve goes on
// to the next piece most of the time (a coherent step, copying the example verbatim) and now and
// then jumps to another place that looks alike. A last, tiny share of the probability leads
// anywhere, so that every condition on the walk can be met.
//
//     P(j, k) = coherent[j] [k = j + 1]  +  jump[j][k]  +  anywhere[j] landing[k] / landings
//
// Sampling: backward filtering, forward sampling. Messages m_i(j) = l_i(j) sum_k P(j, k)
// m_{i+1}(k), scaled to a maximum of 1 at each step so that no length underflows, give the exact
// conditional distribution of each state given the one before it and everything that follows. The
// best path is the same recursion with (min, +) in place of (+, *): Viterbi's algorithm from the
// end. Both cost O(steps * (states + jumps)) time and O(sqrt(steps) * states) memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/base/random.h"

namespace libstyle {

using ChainState = std::uint32_t;

struct ChainJump {
  ChainState target = 0;
  double probability = 0;
};

// The transitions out of one state; with the landing share they sum to 1.
struct ChainRow {
  double coherent = 0;           // to the next state; 0 at the end of an example
  double anywhere = 0;           // shared equally by all landings; > 0
  std::vector<ChainJump> jumps;  // targets rising, each once, none of them the next state
};

struct ChainModel {
  std::vector<ChainRow> rows;
  std::vector<std::uint8_t> landing;  // 1 where a jump may land; at least one

  std::size_t state_count() const { return rows.size(); }
};

// Adds to costs[j] what it costs (-log of a likelihood, finite) that `step` is drawn from state j.
// Returns false where that is nothing.
using StepCosts = std::function<bool(std::size_t step, std::span<double> costs)>;

// What a walk has to do.
struct ChainTask {
  std::size_t steps = 0;
  StepCosts costs;                   // may be empty
  std::optional<ChainState> origin;  // the first state, if it is given
  // The state that the last step leads to, if it is given: `origin` on a closed curve.
  std::optional<ChainState> next;
};

// What keeps a sampled walk from being seen to repeat itself. Each step is drawn from the chain's
// distribution, conditions and all, with two changes.
struct ChainVariety {
  // The most steps copied in one go; 0: any number. Beyond half of it going on becomes less and
  // less likely, so that a walk that can leave well does so before it must.
  std::size_t longest_run = 0;
  // A jump to a state that was drawn n times before has this to the power of n of its probability;
  // 1: repeats do not matter.
  double repeat_factor = 1;
  // What the walk is a piece of: how often each state is drawn elsewhere, none if empty, and for
  // how many steps the run that the origin is the last of goes on already.
  std::span<const int> uses = {};
  std::size_t run_before = 0;
};

// A walk with the probability that the chain gives to it under the task, but for the variety asked
// for. `random` is asked for one number a step, at places first_place, first_place + 1, ...
std::vector<ChainState> sample_chain(const ChainModel& model, const ChainTask& task,
                                     const RandomStream& random, std::uint64_t first_place = 0,
                                     const ChainVariety& variety = {});

// The most probable walk; of equals the one with the lowest states.
std::vector<ChainState> best_chain(const ChainModel& model, const ChainTask& task);

// The probability of a step from one state to another.
double transition_probability(const ChainModel& model, ChainState from, ChainState to);

}  // namespace libstyle
