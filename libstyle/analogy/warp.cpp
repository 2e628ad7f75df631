// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/warp.h"

#include <algorithm>
#include <cmath>

namespace libstyle {

Warp::Warp(std::span<const WarpTarget> targets, double width)
    : targets_(targets.begin(), targets.end()), width_(width) {
  const auto earlier = [](const WarpTarget& a, const WarpTarget& b) {
    return a.position < b.position;
  };
  const auto together = [](const WarpTarget& a, const WarpTarget& b) {
    return a.position == b.position;
  };
  std::stable_sort(targets_.begin(), targets_.end(), earlier);
  targets_.erase(std::unique(targets_.begin(), targets_.end(), together), targets_.end());
}

Vector Warp::at(double position) const {
  if (targets_.empty()) return {};
  const auto after = std::ranges::upper_bound(targets_, position, {}, &WarpTarget::position);
  if (after == targets_.begin()) return bump(targets_.front(), position);
  const WarpTarget& left = *std::prev(after);
  if (after == targets_.end()) return bump(left, position);
  const WarpTarget& right = *after;
  const double u = (position - left.position) / (right.position - left.position);
  return lerp(bump(left, position), bump(right, position), u * u * (3 - 2 * u));
}

Vector Warp::bump(const WarpTarget& target, double position) const {
  const double ratio = (position - target.position) / (target.widening * width_);
  return std::exp(-0.5 * ratio * ratio) * target.offset;
}

}  // namespace libstyle
