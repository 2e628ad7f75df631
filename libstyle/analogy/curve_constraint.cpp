// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/curve_constraint.h"

#include <algorithm>
#include <cmath>

#include "libstyle/base/error.h"
#include "libstyle/base/number.h"

namespace libstyle {
namespace {

// Two constraints on one place as one.
CurveConstraint combined(const CurveConstraint& a, const CurveConstraint& b) {
  if (!a.weight && !b.weight && a.position != b.position) {
    throw Error("two hard constraints want one point of a curve at " + text_of(a.position) +
                " and at " + text_of(b.position) + "; take one away or give it a weight");
  }
  if (!a.weight) return a;
  if (!b.weight) return {a.t, b.position, {}};
  const double weight = *a.weight + *b.weight;
  return {a.t, lerp(a.position, b.position, *b.weight / weight), weight};
}

}  // namespace

std::string text_of(Point position) {
  std::string text;
  append_number(text, position.x);
  text += ',';
  append_number(text, position.y);
  return text;
}

std::vector<CurveConstraint> checked_constraints(std::span<const CurveConstraint> constraints) {
  std::vector<CurveConstraint> sorted(constraints.begin(), constraints.end());
  std::ranges::stable_sort(sorted, {}, &CurveConstraint::t);
  for (const CurveConstraint& c : sorted) {
    if (!(c.t >= 0 && c.t <= 1)) throw Error("a constraint has a t outside 0 .. 1");
    if (!is_finite(c.position)) throw Error("a constraint has no finite position");
    if (c.weight && !(*c.weight > 0 && std::isfinite(*c.weight))) {
      throw Error(
          "a constraint has a weight that is not a positive number; leave it out to make "
          "the constraint hard");
    }
  }
  distinct_constraints(sorted, 0);
  return sorted;
}

std::vector<CurveConstraint> distinct_constraints(std::span<const CurveConstraint> constraints,
                                                  double apart) {
  std::vector<CurveConstraint> result;
  for (const CurveConstraint& constraint : constraints) {
    if (!result.empty() && constraint.t - result.back().t <= apart) {
      result.back() = combined(result.back(), constraint);
    } else {
      result.push_back(constraint);
    }
  }
  return result;
}

}  // namespace libstyle
