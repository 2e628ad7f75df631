// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/jump_costs.h"

#include <algorithm>
#include <cmath>

namespace libstyle {
namespace {

constexpr double kReach = 2;              // feature sizes to each side
constexpr double kSamplesPerFeature = 4;  // as many as fit whole steps
constexpr std::size_t kComponents = 4;    // offset and tangent of a lane, before its features
constexpr double kFeatureWeight = 0.1;    // a squared spread, in squared feature sizes
constexpr double kRounding = 1e-9;        // samples that lie on the end of a line exist

}  // namespace

JumpCosts::JumpCosts(const Example& example)
    : example_(example),
      components_(example.lane_count() * (kComponents + example.features().size())) {
  weigh_features();
  lay_grid();
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

void JumpCosts::lay_grid() {
  const double feature = example_.feature_along();
  fine_ = static_cast<std::size_t>(
      std::max(1.0, std::round(kSamplesPerFeature * example_.step() / feature)));
  const double spacing = example_.step() / static_cast<double>(fine_);
  reach_ = static_cast<int>(kReach * feature / spacing + kRounding);
  weight_sums_ = {0};
  for (int tap = -reach_; tap <= reach_; ++tap) {
    const double sigmas = tap * spacing / feature;
    tap_weights_.push_back(std::exp(-0.5 * sigmas * sigmas));
    weight_sums_.push_back(weight_sums_.back() + tap_weights_.back());
  }
  rows_.resize(tap_weights_.size());

  const std::size_t margin = static_cast<std::size_t>(reach_) / fine_ + 1;
  for (std::size_t j = 0; j < example_.state_count(); ++j) {
    if (j == 0 || !example_.has_next(j - 1)) slots_ += margin;
    starts_.push_back(slots_++);
    // The end of the last state is a place, too.
    if (!example_.has_next(j)) slots_ += 1 + margin;
  }
  samples_.resize(components_ * slots_ * fine_);
  present_.resize(slots_ * fine_);
  sums_.resize(slots_);
  for (std::size_t first = 0, end = 0; first < starts_.size(); first = end) {
    for (end = first + 1; example_.has_next(end - 1);) ++end;
    sample_line(example_.line(first), starts_[first] * fine_, end - first);
  }
  for (const std::size_t start : starts_) taps_.push_back(taps_at(start * fine_));
}

void JumpCosts::sample_line(const ExampleLine& line, std::size_t first_place, std::size_t states) {
  const double spacing = example_.step() / static_cast<double>(fine_);
  const double slack = kRounding * line.length();
  const int last = static_cast<int>(states * fine_) + reach_;
  std::vector<double> components;
  for (int i = -reach_; i <= last; ++i) {
    const double length = i * spacing;
    if (!line.goes_round() && !(length >= -slack && length <= line.length() + slack)) continue;
    const std::size_t slot = at(first_place + static_cast<std::size_t>(i));
    present_[slot] = 1;
    components.clear();
    for (const Lane& lane : line.lanes()) append_components(components, lane, length);
    for (std::size_t c = 0; c < components_; ++c) {
      samples_[c * present_.size() + slot] = components[c];
    }
  }
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

JumpCosts::Taps JumpCosts::taps_at(std::size_t place) const {
  const auto is_there = [&](std::size_t tap) {
    return present_[at(place + tap - static_cast<std::size_t>(reach_))] != 0;
  };
  Taps taps{0, tap_weights_.size()};
  while (taps.begin < taps.end && !is_there(taps.begin)) ++taps.begin;
  while (taps.begin < taps.end && !is_there(taps.end - 1)) --taps.end;
  return taps;
}

double JumpCosts::weight_of(Taps taps) const {
  return taps.begin < taps.end ? weight_sums_[taps.end] - weight_sums_[taps.begin] : 0;
}

// Where there is no sample the difference is 0.
const std::vector<double>& JumpCosts::differences_from(std::size_t place) {
  Row& row = rows_[place % rows_.size()];
  if (row.place == place) return row.differences;
  row.place = place;
  row.differences.assign(slots_, 0.0);
  double* sums = row.differences.data();
  const double* others = samples_.data() + (place % fine_) * slots_;
  for (std::size_t c = 0; c < components_; ++c, others += present_.size()) {
    const double own = others[place / fine_];
    for (std::size_t s = 0; s < slots_; ++s) sums[s] += (others[s] - own) * (others[s] - own);
  }
  const double* present = present_.data() + (place % fine_) * slots_;
  for (std::size_t s = 0; s < slots_; ++s) sums[s] *= present[s];
  return row.differences;
}

void JumpCosts::compare(std::size_t place, std::span<double> costs) {
  const Taps taps = taps_at(place);
  std::ranges::fill(sums_, 0.0);
  for (std::size_t tap = taps.begin; tap < taps.end; ++tap) {
    const std::size_t sample = place + tap - static_cast<std::size_t>(reach_);
    const double* differences = differences_from(sample).data();
    const double weight = tap_weights_[tap];
    // The same tap of the place in slot s is in slot s + shift.
    const auto shift =
        static_cast<std::ptrdiff_t>(sample / fine_) - static_cast<std::ptrdiff_t>(place / fine_);
    const auto first = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, -shift));
    const std::size_t end = slots_ - static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, shift));
    for (std::size_t s = first; s < end; ++s) {
      sums_[s] += weight * differences[s + static_cast<std::size_t>(shift)];
    }
  }
  for (std::size_t k = 0; k < costs.size(); ++k) {
    const Taps common{std::max(taps.begin, taps_[k].begin), std::min(taps.end, taps_[k].end)};
    const double weight = weight_of(common);
    costs[k] = weight > 0 ? sums_[starts_[k]] / weight : std::numeric_limits<double>::infinity();
  }
}

void JumpCosts::from_start_of(std::size_t from, std::span<double> costs) {
  compare(starts_[from] * fine_, costs);
}

void JumpCosts::from_end_of(std::size_t from, std::span<double> costs) {
  compare((starts_[from] + 1) * fine_, costs);
}

}  // namespace libstyle
