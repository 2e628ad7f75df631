// SPDX-License-Identifier: Apache-2.0
// Places that a drawn curve must pass through or is drawn towards.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libstyle/geometry/point.h"

namespace libstyle {

// <t_c, q_c, w_c> of the paper, section 3.2: where B' has parameter t it is to be at `position`.
// The weight is the inverse of a variance: at 0.01 the curve may well be 10 px off.
struct CurveConstraint {
  double t = 0;                  // 0 .. 1, a fraction of the length of B
  Point position;                // px
  std::optional<double> weight;  // > 0, 1/px^2; unset: hard

  friend bool operator==(const CurveConstraint&, const CurveConstraint&) = default;
};

// "1,2": a position in messages.
std::string text_of(Point position);

// By rising t. Throws Error when one is out of range, or when two hard ones want one point of the
// curve at different positions.
std::vector<CurveConstraint> checked_constraints(std::span<const CurveConstraint> constraints);

// With those that are no farther apart in t than `apart` made one: a hard one, or the mean of soft
// ones, which weighs as much as all of them. `constraints` by rising t. Throws Error as above.
std::vector<CurveConstraint> distinct_constraints(std::span<const CurveConstraint> constraints,
                                                  double apart);

}  // namespace libstyle
