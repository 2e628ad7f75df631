// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/jump_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "libstyle/analogy/jump_costs.h"

namespace libstyle {
namespace {

constexpr std::size_t kMaxJumps = 16;     // the best of a state; more are hardly ever taken
constexpr double kApart = 2;              // feature sizes between different places
constexpr double kAnywhere = 1e-9;        // probability of a step that pays no heed to looks
constexpr double kLeastTolerance = 1e-4;  // of the squared feature size, for exact repetitions
constexpr double kLeastWeight = 1e-12;    // of a jump; less is never taken
constexpr double kLargestJumpProbability = 0.5;

class JumpModelMaker {
 public:
  JumpModelMaker(const Example& example, const JumpParameters& parameters)
      : example_(example), costs_(example), parameters_(parameters) {
    find_landings();
    compare_places();
    find_tolerance();
    weigh_jumps();
    set_probabilities();
  }

  JumpModel take() { return std::move(model_); }

 private:
  struct Candidate {
    ChainState target = 0;
    double cost = 0;  // px^2
  };

  // Whether a jump to the beginning of `to` would only repeat what is around `length` of `from`.
  bool too_near(std::size_t from, double length, std::size_t to) const {
    if (example_.line_of(from) != example_.line_of(to)) return false;
    const ExampleLine& line = example_.line(from);
    double away = std::abs(length - example_.length_of(to));
    if (line.goes_round()) away = std::min(away, std::abs(line.length() - away));
    return away < apart_of(from);
  }

  // A short line has no two places that far apart; a quarter of it has to do. States lie whole
  // steps apart, and the quarter of a step keeps rounding from deciding about them.
  double apart_of(std::size_t state) const {
    return std::min(kApart * example_.feature_along(), example_.line(state).length() / 4) -
           example_.step() / 4;
  }

  void find_landings() {
    model_.chain.landing.resize(example_.state_count());
    for (std::size_t j = 0; j < example_.state_count(); ++j) {
      const double rest = example_.line(j).length() - example_.length_of(j);
      const bool goes_on = parameters_.ends_allowed || example_.line(j).goes_round();
      model_.chain.landing[j] = goes_on || rest >= apart_of(j);
    }
  }

  // Compares all places with all others. The end of a state is the beginning of the next.
  void compare_places() {
    const std::size_t states = example_.state_count();
    std::vector<double> row(states);
    jumps_.resize(states);
    for (std::size_t j = 0; j < states; ++j) {
      costs_.from_start_of(j, row);
      note_nearest(j, row);
      if (j > 0 && example_.has_next(j - 1)) jumps_[j - 1] = best_jumps(j - 1, row);
      if (example_.has_next(j)) continue;
      costs_.from_end_of(j, row);
      jumps_[j] = best_jumps(j, row);
    }
  }

  void note_nearest(std::size_t from, std::span<const double> row) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (row[k] < least && !too_near(from, example_.length_of(from), k)) least = row[k];
    }
    if (std::isfinite(least)) nearest_.push_back(least);
  }

  void find_tolerance() {
    const double size = example_.feature_size();
    model_.tolerance = kLeastTolerance * size * size;
    if (nearest_.empty()) return;  // there is nothing to jump to
    const auto tenth = nearest_.begin() + static_cast<std::ptrdiff_t>(nearest_.size() / 10);
    std::ranges::nth_element(nearest_, tenth);
    model_.tolerance = parameters_.freedom * std::max(model_.tolerance, *tenth);
  }

  // Local minima only: the best phase of every place, not many of the same. Next to a place that
  // cannot be compared there is too little to compare.
  std::vector<Candidate> best_jumps(std::size_t from, std::span<const double> row) const {
    const double length = example_.length_of(from) + example_.step();
    std::vector<Candidate> found;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const bool least = (k == 0 || (std::isfinite(row[k - 1]) && row[k] <= row[k - 1])) &&
                         (k + 1 == row.size() || row[k] < row[k + 1]);
      if (!least || !model_.chain.landing[k] || too_near(from, length, k)) continue;
      if (example_.has_next(from) && k == from + 1) continue;
      found.push_back({static_cast<ChainState>(k), row[k]});
    }
    const auto cheaper = [](const Candidate& a, const Candidate& b) {
      return std::tie(a.cost, a.target) < std::tie(b.cost, b.target);
    };
    const std::size_t kept = std::min(found.size(), kMaxJumps);
    std::ranges::partial_sort(found, found.begin() + static_cast<std::ptrdiff_t>(kept), cheaper);
    found.resize(kept);
    return found;
  }

  // Fills the jumps with exp(-cost / tolerance), relative to the best one where the line ends and a
  // jump has to be made.
  void weigh_jumps() {
    for (std::size_t j = 0; j < example_.state_count(); ++j) {
      const std::vector<Candidate>& candidates = jumps_[j];
      const double reference = goes_on(j) || candidates.empty() ? 0 : candidates.front().cost;
      std::vector<ChainJump> jumps;
      for (const Candidate& candidate : candidates) {
        const double weight = std::exp((reference - candidate.cost) / model_.tolerance);
        if (weight >= kLeastWeight) jumps.push_back({candidate.target, weight});
      }
      std::ranges::sort(jumps, {}, &ChainJump::target);
      model_.chain.rows.push_back({0, 0, std::move(jumps)});
    }
  }

  // Whether the example goes on after a state, be it at its own beginning.
  bool goes_on(std::size_t j) const {
    return example_.has_next(j) || example_.line(j).goes_round();
  }

  // Leads from the last state of a line that goes round to its first: a jump that shows nothing.
  void close(ChainRow& row, std::size_t last, double probability) const {
    std::size_t first = last;
    while (first > 0 && example_.line_of(first - 1) == example_.line_of(last)) --first;
    const ChainJump jump{static_cast<ChainState>(first), probability};
    row.jumps.insert(std::ranges::upper_bound(row.jumps, jump.target, {}, &ChainJump::target),
                     jump);
  }

  static double mass(const ChainRow& row) {
    double sum = 0;
    for (const ChainJump& jump : row.jumps) sum += jump.probability;
    return sum;
  }

  void set_probabilities() {
    double mean_mass = 0;
    for (const ChainRow& row : model_.chain.rows) mean_mass += mass(row);
    mean_mass /= static_cast<double>(example_.state_count());
    const double usual = example_.step() / (parameters_.mean_run * example_.feature_along());
    for (std::size_t j = 0; j < example_.state_count(); ++j) {
      ChainRow& row = model_.chain.rows[j];
      const double own_mass = mass(row);
      double leave = std::min(kLargestJumpProbability, usual * own_mass / mean_mass);
      if (!goes_on(j)) leave = 1 - kAnywhere;
      if (row.jumps.empty()) leave = 0;
      for (ChainJump& jump : row.jumps) jump.probability *= leave / own_mass;
      row.anywhere = goes_on(j) ? kAnywhere : 1 - leave;
      const double coherent = goes_on(j) ? 1 - leave - kAnywhere : 0;
      if (example_.has_next(j)) {
        row.coherent = coherent;
      } else if (goes_on(j)) {
        close(row, j, coherent);
      }
    }
  }

  const Example& example_;
  JumpCosts costs_;
  JumpParameters parameters_;
  std::vector<double> nearest_;                // for each place, the cost of the nearest other one
  std::vector<std::vector<Candidate>> jumps_;  // for each state, the best, cheapest first
  JumpModel model_;
};

}  // namespace

JumpModel make_jump_model(const Example& example, const JumpParameters& parameters) {
  return JumpModelMaker(example, parameters).take();
}

}  // namespace libstyle
