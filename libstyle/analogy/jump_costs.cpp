// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/jump_costs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace libstyle {
namespace {

constexpr int kReach = 8;  // taps to each side
constexpr std::size_t kTaps = 2 * kReach + 1;
constexpr std::size_t kComponents = 4;  // offset and tangent of a lane, before its features
constexpr double kTapsPerFeature = 4;
constexpr double kFeatureWeight = 0.1;  // a squared spread, in squared feature sizes

constexpr std::size_t kMaxJumps = 16;     // the best of a state; more are hardly ever taken
constexpr double kApart = 2;              // feature sizes between different places
constexpr double kAnywhere = 1e-9;        // probability of a step that pays no heed to looks
constexpr double kLeastTolerance = 1e-4;  // of the squared feature size, for exact repetitions
constexpr double kLargestJumpProbability = 0.5;

double tap_weight(std::size_t tap) {
  const double sigmas = (static_cast<double>(tap) - kReach) / kTapsPerFeature;
  return std::exp(-0.5 * sigmas * sigmas);
}

}  // namespace

struct JumpCosts::Window {
  std::array<std::vector<double>, kTaps> components;
  std::array<bool, kTaps> present;
};

JumpCosts::JumpCosts(const Example& example)
    : example_(example),
      components_(example.lane_count() * (kComponents + example.features().size())),
      windows_(kTaps * components_ * example.state_count()),
      present_(kTaps * example.state_count()) {
  weigh_features();
  const std::size_t states = example.state_count();
  for (std::size_t j = 0; j < states; ++j) {
    const Window window = window_at(example.line(j), example.length_of(j));
    for (std::size_t tap = 0; tap < kTaps; ++tap) {
      present_[tap * states + j] = window.present[tap] ? 1.0 : 0.0;
      for (std::size_t c = 0; c < components_; ++c) {
        windows_[(tap * components_ + c) * states + j] = window.components[tap][c];
      }
    }
  }
}

// The parts of a colour share one spread.
void JumpCosts::weigh_features() {
  const std::span<const LineFeature> features = example_.features();
  for (const LineFeature& feature : features) {
    double variance = 0;
    for (std::size_t i = 0; i < features.size(); ++i) {
      const double spread = example_.statistics(i).spread;
      if (features[i].name == feature.name) variance += spread * spread;
    }
    const double size = std::sqrt(kFeatureWeight) * example_.feature_size();
    feature_weights_.push_back(variance > 0 ? size / std::sqrt(variance) : 0);
  }
}

JumpCosts::Window JumpCosts::window_at(const ExampleLine& line, double length) const {
  Window window;
  const double spacing = example_.feature_along() / kTapsPerFeature;
  const double slack = 1e-9 * line.length();
  for (std::size_t tap = 0; tap < kTaps; ++tap) {
    const double place = length + (static_cast<double>(tap) - kReach) * spacing;
    window.present[tap] = line.goes_round() || (place >= -slack && place <= line.length() + slack);
    for (const Lane& lane : line.lanes()) append_components(window.components[tap], lane, place);
  }
  return window;
}

// A lane with the pen up is nothing: against one with the pen down it counts the offset there and,
// as the tangent, a squared feature size.
void JumpCosts::append_components(std::vector<double>& components, const Lane& lane,
                                  double length) const {
  const std::size_t end = components.size() + components_ / example_.lane_count();
  if (lane.is_down(length)) {
    const Lane::Sample sample = lane.at(length);
    const double size = example_.feature_size();
    components.insert(components.end(), {sample.offset.x, sample.offset.y, size * sample.tangent.x,
                                         size * sample.tangent.y});
    const std::vector<double> features = lane.features_at(length);
    for (std::size_t i = 0; i < features.size(); ++i) {
      components.push_back(feature_weights_[i] * (features[i] - example_.statistics(i).mean));
    }
  }
  components.resize(end);
}

void JumpCosts::compare(const Window& window, std::span<double> costs) const {
  const std::size_t states = example_.state_count();
  std::vector<double> weights(states, 0.0), sums(states);
  std::ranges::fill(costs, 0.0);
  for (std::size_t tap = 0; tap < kTaps; ++tap) {
    if (!window.present[tap]) continue;
    std::ranges::fill(sums, 0.0);
    for (std::size_t c = 0; c < components_; ++c) {
      const double* other = &windows_[(tap * components_ + c) * states];
      const double own = window.components[tap][c];
      for (std::size_t j = 0; j < states; ++j) sums[j] += (other[j] - own) * (other[j] - own);
    }
    const double* present = &present_[tap * states];
    const double weight = tap_weight(tap);
    for (std::size_t j = 0; j < states; ++j) {
      costs[j] += weight * present[j] * sums[j];
      weights[j] += weight * present[j];
    }
  }
  // The middle tap is always there, so no weight is 0.
  for (std::size_t j = 0; j < states; ++j) costs[j] /= weights[j];
}

void JumpCosts::from_end_of(std::size_t from, std::span<double> costs) const {
  compare(window_at(example_.line(from), example_.length_of(from) + example_.step()), costs);
}

void JumpCosts::from_start_of(std::size_t from, std::span<double> costs) const {
  compare(window_at(example_.line(from), example_.length_of(from)), costs);
}

namespace {

// ---- From costs to probabilities --------------------------------------------------------------

class JumpModelMaker {
 public:
  JumpModelMaker(const Example& example, double mean_run, bool ends_allowed)
      : example_(example), costs_(example), mean_run_(mean_run) {
    find_landings(ends_allowed);
    find_tolerance();
    find_jumps();
    set_probabilities();
  }

  JumpModel take() { return std::move(model_); }

 private:
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

  void find_landings(bool ends_allowed) {
    model_.chain.landing.resize(example_.state_count());
    for (std::size_t j = 0; j < example_.state_count(); ++j) {
      const double rest = example_.line(j).length() - example_.length_of(j);
      const bool goes_on = ends_allowed || example_.line(j).goes_round();
      model_.chain.landing[j] = goes_on || rest >= apart_of(j);
    }
  }

  void find_tolerance() {
    const std::size_t states = example_.state_count();
    std::vector<double> row(states), nearest;
    for (std::size_t j = 0; j < states; ++j) {
      costs_.from_start_of(j, row);
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < states; ++k) {
        if (!too_near(j, example_.length_of(j), k)) least = std::min(least, row[k]);
      }
      if (std::isfinite(least)) nearest.push_back(least);
    }
    const double size = example_.feature_size();
    model_.tolerance = kLeastTolerance * size * size;
    if (nearest.empty()) return;
    const auto tenth = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 10);
    std::ranges::nth_element(nearest, tenth);
    model_.tolerance = std::max(model_.tolerance, *tenth);
  }

  // Local minima only: the best phase of every place, not many of the same.
  std::vector<ChainJump> best_jumps(std::size_t from, std::span<const double> row) const {
    const double length = example_.length_of(from) + example_.step();
    std::vector<ChainJump> found;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const bool least =
          (k == 0 || row[k] <= row[k - 1]) && (k + 1 == row.size() || row[k] < row[k + 1]);
      if (!least || !model_.chain.landing[k] || too_near(from, length, k)) continue;
      if (example_.has_next(from) && k == from + 1) continue;
      found.push_back({static_cast<ChainState>(k), row[k]});
    }
    const auto cheaper = [](const ChainJump& a, const ChainJump& b) {
      return a.probability < b.probability ||
             (a.probability == b.probability && a.target < b.target);
    };
    std::ranges::sort(found, cheaper);
    if (found.size() > kMaxJumps) found.resize(kMaxJumps);
    return found;
  }

  // Fills the jumps with exp(-cost / tolerance), relative to the best one where the line ends and a
  // jump has to be made.
  void find_jumps() {
    std::vector<double> row(example_.state_count());
    for (std::size_t j = 0; j < example_.state_count(); ++j) {
      costs_.from_end_of(j, row);
      std::vector<ChainJump> jumps = best_jumps(j, row);
      const double reference = goes_on(j) || jumps.empty() ? 0 : jumps.front().probability;
      for (ChainJump& jump : jumps) {
        jump.probability = std::exp((reference - jump.probability) / model_.tolerance);
      }
      std::erase_if(jumps, [](const ChainJump& jump) { return jump.probability < 1e-12; });
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
    const double usual = example_.step() / (mean_run_ * example_.feature_along());
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
  double mean_run_;
  JumpModel model_;
};

}  // namespace

JumpModel make_jump_model(const Example& example, double mean_run, bool ends_allowed) {
  return JumpModelMaker(example, mean_run, ends_allowed).take();
}

}  // namespace libstyle
