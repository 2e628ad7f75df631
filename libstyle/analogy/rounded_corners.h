// SPDX-License-Identifier: Apache-2.0
// Where a style rounds the corners of its plain line, and how much.
//
// An offset from a plain line that has a corner has a corner itself, with which it takes the one of
// the line away. On a line whose corner is blunter or sharper than the one of the example the two
// no longer cancel, and a kink is left. So around such corners offsets are taken from the plain
// line blurred, and go back to a line that is blurred alike: a corner of any angle comes out round.
//
// The sigma is the one that makes of the corner of the plain line one that bends as the filtered
// curve does at its sharpest near there; it fades to 0 beside it. Corners that the filtered curve
// keeps, or that it does not reach, have none, so that A' = A still gives back B.
#pragma once

#include <span>
#include <vector>

#include "libstyle/geometry/polyline.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {

class RoundedCorners {
 public:
  // There are none.
  RoundedCorners() = default;
  // `filtered` is sampled evenly but for its own corners, and its t is the length along `plain`.
  // `feature`: half the size of a feature, px along the plain line, > 0.
  RoundedCorners(const Polyline& plain, const SampledCurve& filtered, double feature);

  // How much the plain line is to be blurred at a length: sigma in px of arc length.
  double blur_at(double length) const;

 private:
  struct Corner {
    double length = 0;
    double sigma = 0;
  };

  std::vector<Corner> corners_;
  double length_ = 0;  // of the plain line
  bool closed_ = false;
};

}  // namespace libstyle
