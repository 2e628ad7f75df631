// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/shape_costs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace libstyle {
namespace {

constexpr int kReach = 8;  // taps to each side
constexpr std::size_t kTaps = 2 * kReach + 1;
constexpr std::size_t kPerTap = 5;
constexpr std::size_t kComponents = kPerTap * kTaps;
constexpr double kTapsPerFeature = 4;
// What is beyond an end differs from what is not as much as opposite directions do. Without it, an
// end of the example would suit every direction that the example lacks better than its lines do.
constexpr double kBeyond = 2;
// An end belongs to an end, and what is nearer to one than so many feature sizes to what is as
// near.
constexpr double kEndReach = 2;
constexpr double kEndCost = 4;  // -log of how unlikely it is to put an end in the middle; by trial

using Window = std::array<double, kComponents>;

// `length_at(offset)` is the length at so many feature sizes from the middle; differences of places
// are brought to the size of the example by `shrink`.
template <typename LengthAt>
Window window(const Sweep& sweep, double feature_along, double shrink, LengthAt length_at) {
  Window result;
  const Point middle = sweep.point_at(length_at(0.0));
  const Vector frame = sweep.frame_at(length_at(0.0));
  double weights = 0;
  for (std::size_t tap = 0; tap < kTaps; ++tap) {
    const double u = (static_cast<double>(tap) - kReach) / kTapsPerFeature;
    const double weight = std::exp(-0.5 * u * u);
    weights += weight;
    const double length = length_at(u);
    const Vector place =
        std::sqrt(weight) * shrink * to_frame(sweep.point_at(length) - middle, frame);
    const Vector direction =
        std::sqrt(weight) * feature_along * to_frame(sweep.direction_at(length), frame);
    result[kPerTap * tap] = place.x;
    result[kPerTap * tap + 1] = place.y;
    result[kPerTap * tap + 2] = direction.x;
    result[kPerTap * tap + 3] = direction.y;
    const bool beyond = !sweep.closed() && (length < 0 || length > sweep.length());
    result[kPerTap * tap + 4] = beyond ? kBeyond * std::sqrt(weight) * feature_along : 0;
  }
  for (double& value : result) value /= std::sqrt(weights);
  return result;
}

// 1 at an end of a line, 0 from kEndReach on.
struct EndNearness {
  double start = 0, end = 0;
};

EndNearness end_nearness(double from_start, double to_end, double feature_along) {
  const auto near = [&](double away) {
    return std::clamp(1 - away / (kEndReach * feature_along), 0.0, 1.0);
  };
  return {near(from_start), near(to_end)};
}

double squared(double x) { return x * x; }

}  // namespace

ShapeCosts::ShapeCosts(const Example& example, const Sweep& line, const StyleGrid& grid,
                       double weight, double tolerance)
    : states_(example.state_count()), steps_(grid.steps()), factor_(weight / (4 * tolerance)) {
  const double feature = example.feature_along();
  example_windows_.resize(kComponents * states_);
  for (std::size_t j = 0; j < states_; ++j) {
    const ExampleLine& own_line = example.line(j);
    const double middle = example.length_of(j) + example.step() / 2;
    const Window own =
        window(own_line.sweep(), feature, 1, [&](double u) { return middle + u * feature; });
    for (std::size_t c = 0; c < kComponents; ++c) example_windows_[c * states_ + j] = own[c];
    const EndNearness ends = end_nearness(middle, own_line.length() - middle, feature);
    start_nearness_.push_back(own_line.goes_round() ? 0 : ends.start);
    end_nearness_.push_back(own_line.goes_round() ? 0 : ends.end);
  }
  const double steps_per_feature = feature / example.step();
  for (std::size_t i = 0; i < steps_; ++i) {
    const double x = static_cast<double>(i) + 0.5;
    const Window own = window(line, feature, 1 / grid.scale_at(x),
                              [&](double u) { return grid.length_at(x + u * steps_per_feature); });
    line_windows_.insert(line_windows_.end(), own.begin(), own.end());
  }
  feature_steps_ = steps_per_feature;
  closed_ = line.closed();
}

void ShapeCosts::add(std::size_t step, std::span<double> costs) const {
  for (std::size_t c = 0; c < kComponents; ++c) {
    const double own = line_windows_[step * kComponents + c];
    const double* other = &example_windows_[c * states_];
    for (std::size_t j = 0; j < states_; ++j) {
      costs[j] += factor_ * (other[j] - own) * (other[j] - own);
    }
  }
  EndNearness own;
  if (!closed_) {
    const double x = static_cast<double>(step) + 0.5;
    own = end_nearness(x, static_cast<double>(steps_) - x, feature_steps_);
  }
  for (std::size_t j = 0; j < states_; ++j) {
    costs[j] +=
        kEndCost * (squared(start_nearness_[j] - own.start) + squared(end_nearness_[j] - own.end));
  }
}

}  // namespace libstyle
