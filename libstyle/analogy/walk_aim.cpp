// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/walk_aim.h"

#include <algorithm>
#include <cmath>

namespace libstyle {
namespace {

// Moves nearer to each other than two feature sizes depend on each other, so the variance is that
// of moves over so much, a step.
constexpr double kFeaturesInMove = 2;
constexpr double kShare = 0.7;
// Of the inverse of a step. By trial on a coast and loops: beyond, walks repeat a few pieces and
// are hardly nearer.
constexpr double kLargestTilt = 0.5;

double variance_of_moves(const Example& example) {
  const double length = kFeaturesInMove * example.feature_along();
  std::vector<Vector> moves;
  Vector mean;
  for (std::size_t j = 0; j < example.state_count(); ++j) {
    const double from = example.length_of(j);
    const ExampleLine& line = example.line(j);
    if (from + length > line.length()) continue;
    moves.push_back(line.filtered_at(from + length) - line.filtered_at(from));
    mean += moves.back();
  }
  if (moves.empty()) return 0;
  mean = mean / static_cast<double>(moves.size());
  double sum = 0;
  for (const Vector move : moves) sum += squared_norm(move - mean) / 2;
  return sum / static_cast<double>(moves.size()) * example.step() / length;
}

}  // namespace

WalkAim::WalkAim(const Example& example, std::span<const Stretch> stretches)
    : step_(example.step()),
      variance_(variance_of_moves(example)),
      stretches_(stretches.begin(), stretches.end()),
      tilts_(stretches.size()) {
  for (std::size_t j = 0; j < example.state_count(); ++j) {
    const double from = example.length_of(j);
    const ExampleLine& line = example.line(j);
    drawn_.push_back(line.filtered_at(from + step_) - line.filtered_at(from));
  }
}

bool WalkAim::add(std::size_t step, std::span<double> costs) const {
  const double middle = static_cast<double>(step) + 0.5;
  const auto after = std::ranges::upper_bound(stretches_, middle, {}, &Stretch::end);
  if (after == stretches_.end() || middle < after->begin) return false;
  const Vector tilt = tilts_[static_cast<std::size_t>(after - stretches_.begin())];
  if (tilt == Vector{}) return false;
  for (std::size_t j = 0; j < costs.size(); ++j) costs[j] -= dot(tilt, drawn_[j]);
  return true;
}

void WalkAim::correct(std::span<const Vector> moves) {
  if (!(variance_ > 0)) return;
  for (std::size_t i = 0; i < tilts_.size(); ++i) {
    const double steps = stretches_[i].end - stretches_[i].begin;
    tilts_[i] += kShare / (steps * variance_) * (stretches_[i].move - moves[i]);
    const double size = norm(tilts_[i]) * step_;
    if (size > kLargestTilt) tilts_[i] *= kLargestTilt / size;
  }
}

}  // namespace libstyle
