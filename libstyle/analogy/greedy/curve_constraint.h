// SPDX-License-Identifier: Apache-2.0
// Places that a drawn curve must pass through or is drawn towards.
#pragma once

#include <optional>
#include <span>

#include "libstyle/geometry/point.h"

namespace libstyle {

// <t_c, q_c, w_c> of the paper, section 3.2: where B' has parameter t it is to be at `position`.
struct CurveConstraint {
  double t = 0;                  // 0 .. 1
  Point position;                // px
  std::optional<double> weight;  // > 0, in units of w_new; unset: hard

  friend bool operator==(const CurveConstraint&, const CurveConstraint&) = default;
};

// The weight at a level that many levels above the finest (section 3.4): a constraint is seen as a
// Gaussian of variance 1 / w_c, and each level above adds 1 to the variance, so that coarse curves,
// which cannot bend as the finest can, are not torn by it. Unset: hard, and only at the finest
// level. The printed formula has the added term inverted: it drops all constraints at the finest.
inline std::optional<double> softened_weight(std::optional<double> weight, int levels_above) {
  if (levels_above == 0) return weight;
  return 1 / ((weight ? 1 / *weight : 0.0) + levels_above);
}

}  // namespace libstyle
