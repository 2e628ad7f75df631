// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/chain.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "libstyle/analogy/message_tape.h"

namespace libstyle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double landing_share(const ChainModel& model) {
  const int landings = std::accumulate(model.landing.begin(), model.landing.end(), 0);
  assert(landings > 0);
  return 1.0 / landings;
}

// The costs of steps, one after the other.
class CostsOfSteps {
 public:
  CostsOfSteps(const ChainModel& model, const ChainTask& task)
      : task_(task), costs_(task.costs ? model.state_count() : 0, 0.0) {}

  // Until the next call; empty where there are none.
  std::span<const double> of(std::size_t step) {
    if (are_used_) std::ranges::fill(costs_, 0.0);
    are_used_ = task_.costs && task_.costs(step, costs_);
    if (!are_used_) return {};
    return costs_;
  }

 private:
  const ChainTask& task_;
  std::vector<double> costs_;
  bool are_used_ = false;
};

// The jumps of all rows in one piece of memory, each with a value.
class AllJumps {
 public:
  struct Jump {
    ChainState target;
    double value;
  };

  template <typename Value>
  AllJumps(const ChainModel& model, Value value) : firsts_{0} {
    for (const ChainRow& row : model.rows) {
      for (const ChainJump& jump : row.jumps) jumps_.push_back({jump.target, value(row, jump)});
      firsts_.push_back(jumps_.size());
    }
  }

  std::span<const Jump> from(ChainState state) const {
    return {jumps_.data() + firsts_[state], firsts_[state + 1] - firsts_[state]};
  }

 private:
  std::vector<Jump> jumps_;
  std::vector<std::size_t> firsts_;  // of each state, and one more
};

// The probability of what follows the last step: anything, or what is given.
double ending_probability(const ChainModel& model, const ChainTask& task, ChainState from) {
  return task.next ? transition_probability(model, from, *task.next) : 1.0;
}

// ---- Sampling: sums of probabilities --------------------------------------------------------

class SumMessages {
 public:
  SumMessages(const ChainModel& model, const ChainTask& task)
      : model_(model),
        task_(task),
        costs_(model, task),
        jumps_(model, [](const ChainRow&, const ChainJump& jump) { return jump.probability; }),
        landing_share_(landing_share(model)) {}

  void operator()(std::size_t step, std::span<const double> next, std::span<double> message) {
    const double mean = next.empty() ? 0 : landing_mean(next);
    for (ChainState j = 0; j < message.size(); ++j) message[j] = follow(j, next, mean);
    const std::span<const double> costs = costs_.of(step);
    if (!costs.empty()) {
      const double least = *std::ranges::min_element(costs);
      for (std::size_t j = 0; j < message.size(); ++j) message[j] *= std::exp(least - costs[j]);
    }
    const double largest = *std::ranges::max_element(message);
    for (double& value : message) value /= largest;
  }

  // The distribution of the state after `from`, up to a factor.
  void weigh_successors(ChainState from, std::span<const double> message,
                        std::span<double> weights) const {
    const ChainRow& row = model_.rows[from];
    for (std::size_t k = 0; k < weights.size(); ++k) {
      weights[k] = model_.landing[k] ? row.anywhere * landing_share_ * message[k] : 0.0;
    }
    if (row.coherent > 0) weights[from + 1] += row.coherent * message[from + 1];
    for (const ChainJump& jump : row.jumps) {
      weights[jump.target] += jump.probability * message[jump.target];
    }
  }

 private:
  double landing_mean(std::span<const double> next) const {
    double sum = 0;
    for (std::size_t k = 0; k < next.size(); ++k) sum += model_.landing[k] ? next[k] : 0.0;
    return sum * landing_share_;
  }

  double follow(ChainState from, std::span<const double> next, double mean) const {
    if (next.empty()) return ending_probability(model_, task_, from);
    const ChainRow& row = model_.rows[from];
    double sum = row.anywhere * mean;
    if (row.coherent > 0) sum += row.coherent * next[from + 1];
    for (const AllJumps::Jump& jump : jumps_.from(from)) sum += jump.value * next[jump.target];
    return sum;
  }

  const ChainModel& model_;
  const ChainTask& task_;
  CostsOfSteps costs_;
  AllJumps jumps_;
  double landing_share_;
};

// ---- Best path: least costs -----------------------------------------------------------------

class LeastMessages {
 public:
  LeastMessages(const ChainModel& model, const ChainTask& task)
      : model_(model),
        task_(task),
        costs_(model, task),
        landing_share_(landing_share(model)),
        jumps_(model, [&](const ChainRow& row, const ChainJump& jump) {
          return -std::log(jump.probability + landing_at(jump.target, row));
        }) {
    for (ChainState j = 0; j < model.state_count(); ++j) {
      const ChainRow& row = model.rows[j];
      anywhere_costs_.push_back(-std::log(row.anywhere * landing_share_));
      coherent_costs_.push_back(row.coherent > 0 ? -std::log(row.coherent + landing_at(j + 1, row))
                                                 : kInfinity);
    }
  }

  void operator()(std::size_t step, std::span<const double> next, std::span<double> message) {
    const Choice landing = next.empty() ? Choice{} : best_landing(next);
    for (ChainState j = 0; j < message.size(); ++j) {
      message[j] = next.empty() ? -std::log(ending_probability(model_, task_, j))
                                : best_successor(j, next, landing).cost;
    }
    const std::span<const double> costs = costs_.of(step);
    for (std::size_t j = 0; j < costs.size(); ++j) message[j] += costs[j];
  }

  ChainState best_successor(ChainState from, std::span<const double> message) const {
    return best_successor(from, message, best_landing(message)).state;
  }

 private:
  struct Choice {
    double cost = kInfinity;
    ChainState state = 0;

    void consider(double other_cost, ChainState other) {
      if (other_cost < cost || (other_cost == cost && other < state)) *this = {other_cost, other};
    }
  };

  double landing_at(ChainState state, const ChainRow& row) const {
    return model_.landing[state] ? row.anywhere * landing_share_ : 0.0;
  }

  Choice best_landing(std::span<const double> next) const {
    Choice best;
    for (ChainState k = 0; k < next.size(); ++k) {
      if (model_.landing[k]) best.consider(next[k], k);
    }
    return best;
  }

  Choice best_successor(ChainState from, std::span<const double> next, Choice landing) const {
    const ChainRow& row = model_.rows[from];
    Choice best{landing.cost + anywhere_costs_[from], landing.state};
    if (row.coherent > 0) best.consider(next[from + 1] + coherent_costs_[from], from + 1);
    for (const AllJumps::Jump& jump : jumps_.from(from)) {
      best.consider(next[jump.target] + jump.value, jump.target);
    }
    return best;
  }

  const ChainModel& model_;
  const ChainTask& task_;
  CostsOfSteps costs_;
  double landing_share_;
  AllJumps jumps_;
  std::vector<double> anywhere_costs_;
  std::vector<double> coherent_costs_;
};

// ---- Variety ----------------------------------------------------------------------------------

// What a walk has drawn so far.
class WalkMemory {
 public:
  WalkMemory(std::size_t states, const ChainVariety& variety)
      : variety_(variety),
        uses_(variety.uses.begin(), variety.uses.end()),
        run_(variety.run_before) {
    uses_.resize(states, 0);
    for (const int uses : uses_) factors_.push_back(std::pow(variety.repeat_factor, uses));
  }

  // The first state goes on with the run before.
  void note(ChainState state) {
    const bool goes_on = is_first_ || state == last_ + 1;
    run_ = goes_on ? run_ + 1 : 1;
    is_first_ = false;
    last_ = state;
    factors_[state] = std::pow(variety_.repeat_factor, ++uses_[state]);
  }

  // Changes the weights of the states after the last. They stay as they are where all would
  // vanish.
  void weigh(const ChainRow& row, std::span<double> weights) {
    weighed_.assign(weights.begin(), weights.end());
    double sum = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      if (weighed_[k] == 0) continue;
      const bool coherent = row.coherent > 0 && k == last_ + 1;
      weighed_[k] *= coherent ? going_on() : factors_[k];
      sum += weighed_[k];
    }
    if (sum > 0) std::ranges::copy(weighed_, weights.begin());
  }

 private:
  // 1 up to half the longest run, then falling evenly to 0 at its end.
  double going_on() const {
    if (variety_.longest_run == 0) return 1;
    const double share = static_cast<double>(run_) / static_cast<double>(variety_.longest_run);
    return std::clamp(2 - 2 * share, 0.0, 1.0);
  }

  const ChainVariety variety_;
  std::vector<int> uses_;
  std::vector<double> factors_;  // of jumps to each state
  std::vector<double> weighed_;
  ChainState last_ = 0;
  bool is_first_ = true;
  std::size_t run_;
};

}  // namespace

std::vector<ChainState> sample_chain(const ChainModel& model, const ChainTask& task,
                                     const RandomStream& random, std::uint64_t first_place,
                                     const ChainVariety& variety) {
  SumMessages messages(model, task);
  MessageTape tape(task.steps, model.state_count(), std::ref(messages));
  std::vector<double> weights(model.state_count());
  std::vector<ChainState> walk;
  walk.reserve(task.steps);
  WalkMemory memory(model.state_count(), variety);
  for (std::size_t step = 0; step < task.steps; ++step) {
    const std::span<const double> message = tape.at(step);
    if (step == 0) {
      std::ranges::copy(message, weights.begin());
    } else {
      messages.weigh_successors(walk.back(), message, weights);
      memory.weigh(model.rows[walk.back()], weights);
    }
    const bool given = step == 0 && task.origin;
    walk.push_back(given ? *task.origin
                         : static_cast<ChainState>(random.choose(first_place + step, weights)));
    memory.note(walk.back());
  }
  return walk;
}

std::vector<ChainState> best_chain(const ChainModel& model, const ChainTask& task) {
  LeastMessages messages(model, task);
  MessageTape tape(task.steps, model.state_count(), std::ref(messages));
  std::vector<ChainState> walk;
  walk.reserve(task.steps);
  for (std::size_t step = 0; step < task.steps; ++step) {
    const std::span<const double> message = tape.at(step);
    if (step > 0) {
      walk.push_back(messages.best_successor(walk.back(), message));
    } else if (task.origin) {
      walk.push_back(*task.origin);
    } else {
      walk.push_back(static_cast<ChainState>(std::ranges::min_element(message) - message.begin()));
    }
  }
  return walk;
}

double transition_probability(const ChainModel& model, ChainState from, ChainState to) {
  const ChainRow& row = model.rows[from];
  double sum = model.landing[to] ? row.anywhere * landing_share(model) : 0.0;
  if (to == from + 1) sum += row.coherent;
  for (const ChainJump& jump : row.jumps) {
    if (jump.target == to) sum += jump.probability;
  }
  return sum;
}

}  // namespace libstyle
