// SPDX-License-Identifier: Apache-2.0
// Moves a curve through given places with the least visible change.
#pragma once

#include <span>
#include <vector>

#include "libstyle/geometry/point.h"

namespace libstyle {

// At `position` along the curve, the curve is to be moved by `offset`.
struct WarpTarget {
  double position = 0;
  Vector offset;
};

// The sum of one Gaussian of standard deviation `width` (> 0) at each target, with the coefficients
// that move every target by exactly its offset (to rounding). Targets nearer to each other than
// about width / 1000 count as one, and the first decides.
class Warp {
 public:
  Warp(std::span<const WarpTarget> targets, double width);

  Vector at(double position) const;

 private:
  double kernel(double distance) const;

  std::vector<WarpTarget> bumps_;  // offset: the coefficient
  double width_;
};

}  // namespace libstyle
