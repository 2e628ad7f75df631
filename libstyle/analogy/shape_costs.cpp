// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/shape_costs.h"

#include <array>
#include <cmath>

namespace libstyle {
namespace {

constexpr int kReach = 8;  // taps to each side
constexpr std::size_t kTaps = 2 * kReach + 1;
constexpr std::size_t kComponents = 4 * kTaps;
constexpr double kTapsPerFeature = 4;
constexpr double kEndCost = 4;  // -log of how unlikely it is to begin in the middle; by trial

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
    result[4 * tap] = place.x;
    result[4 * tap + 1] = place.y;
    result[4 * tap + 2] = direction.x;
    result[4 * tap + 3] = direction.y;
  }
  for (double& value : result) value /= std::sqrt(weights);
  return result;
}

}  // namespace

ShapeCosts::ShapeCosts(const Example& example, const Sweep& line, const StyleGrid& grid,
                       double weight, double tolerance)
    : states_(example.state_count()), steps_(grid.steps()), factor_(weight / (4 * tolerance)) {
  const double feature = example.feature_along();
  example_windows_.resize(kComponents * states_);
  for (std::size_t j = 0; j < states_; ++j) {
    const double middle = example.length_of(j) + example.step() / 2;
    const Window own =
        window(example.line(j).sweep(), feature, 1, [&](double u) { return middle + u * feature; });
    for (std::size_t c = 0; c < kComponents; ++c) example_windows_[c * states_ + j] = own[c];
    const bool begins = j == 0 || !example.has_next(j - 1);
    start_costs_.push_back(line.closed() || begins ? 0 : kEndCost);
    end_costs_.push_back(line.closed() || !example.has_next(j) ? 0 : kEndCost);
  }
  const double steps_per_feature = feature / example.step();
  for (std::size_t i = 0; i < steps_; ++i) {
    const double x = static_cast<double>(i) + 0.5;
    const Window own = window(line, feature, 1 / grid.scale_at(x),
                              [&](double u) { return grid.length_at(x + u * steps_per_feature); });
    line_windows_.insert(line_windows_.end(), own.begin(), own.end());
  }
}

void ShapeCosts::add(std::size_t step, std::span<double> costs) const {
  for (std::size_t c = 0; c < kComponents; ++c) {
    const double own = line_windows_[step * kComponents + c];
    const double* other = &example_windows_[c * states_];
    for (std::size_t j = 0; j < states_; ++j) {
      costs[j] += factor_ * (other[j] - own) * (other[j] - own);
    }
  }
  for (std::size_t j = 0; j < states_; ++j) {
    if (step == 0) costs[j] += start_costs_[j];
    if (step + 1 == steps_) costs[j] += end_costs_[j];
  }
}

}  // namespace libstyle
