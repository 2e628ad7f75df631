// SPDX-License-Identifier: Apache-2.0
// Moves a curve through given places with little visible change.
#pragma once

#include <span>
#include <vector>

#include "libstyle/geometry/point.h"

namespace libstyle {

// At `position` along the curve, the curve is to be moved by `offset`.
struct WarpTarget {
  double position = 0;
  Vector offset;
  double widening = 1;  // how many times as wide its bump is as the others
};

// A smooth offset along the curve that is exactly that of each target there and fades between them.
//
// Alone, a target makes a Gaussian bump k of standard deviation `width` (> 0), or its multiple of
// it. Between neighbours
// at p and q, with u = (x - p) / (q - p) and S(u) = 3 u^2 - 2 u^3,
//
//     offset(x) = (1 - S(u)) k(x - p) offset_p + S(u) k(x - q) offset_q
//
// which has no kinks and is never larger than the larger of the two, however near the targets are
// to each other. (Bumps whose heights solve a linear system are smoother, but swing wildly between
// targets much nearer than their width, and three of those make the system singular.) Of targets at
// the same place the first one given counts. Cost: O(log n) a place.
class Warp {
 public:
  Warp(std::span<const WarpTarget> targets, double width);

  Vector at(double position) const;

 private:
  Vector bump(const WarpTarget& target, double position) const;

  std::vector<WarpTarget> targets_;  // by rising position
  double width_;
};

}  // namespace libstyle
