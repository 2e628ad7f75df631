// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/line_constraints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "libstyle/geometry/arc_length.h"

namespace libstyle {
namespace {

bool is_near(double a, double b, double margin) { return std::abs(a - b) <= margin; }

// The nearest of rising values, if one is within the margin.
std::optional<double> nearest_within(std::span<const double> values, double x, double margin) {
  const auto after = std::ranges::lower_bound(values, x);
  std::optional<double> nearest;
  if (after != values.end()) nearest = *after;
  if (after != values.begin() && (!nearest || x - *std::prev(after) <= *nearest - x)) {
    nearest = *std::prev(after);
  }
  return nearest && is_near(*nearest, x, margin) ? nearest : std::nullopt;
}

// What counts where several things are asked of one place.
enum class Rank { kHeld, kEnd, kConstraint };

struct Ranked {
  LineConstraint constraint;
  Rank rank;
};

}  // namespace

LineConstraints::LineConstraints(const Polyline& curve, std::span<const PlainLine> lines,
                                 const CurveConditions& conditions)
    : length_(arc_length(curve)), closed_(curve.closed), keep_ends_(conditions.keep_ends) {
  if (keep_ends_) held_.assign(conditions.held.begin(), conditions.held.end());
  if (conditions.constraints.empty()) return;
  gather(curve, lines, conditions.constraints);
  if (keep_ends_) settle_at_held_places(curve, conditions.deviation);
}

void LineConstraints::gather(const Polyline& curve, std::span<const PlainLine> lines,
                             std::span<const CurveConstraint> constraints) {
  const double margin = kSameLength * length_;
  for (const PlainLine& line : lines) {
    if (line.starts_at_corner || !curve.closed) ends_.push_back(line.length_before);
  }
  if (!curve.closed) ends_.push_back(length_);
  std::vector<CurveConstraint> snapped = checked_constraints(constraints);
  for (CurveConstraint& constraint : snapped) {
    double length = constraint.t * length_;
    if (curve.closed && is_near(length, length_, margin)) length = 0;
    constraint.t = nearest_within(ends_, length, margin).value_or(length) / length_;
  }
  std::ranges::stable_sort(snapped, {}, &CurveConstraint::t);
  for (const CurveConstraint& constraint : distinct_constraints(snapped, kSameLength)) {
    constraints_.push_back({constraint.t * length_, constraint.position, constraint.weight});
  }
}

void LineConstraints::settle_at_held_places(const Polyline& curve, double deviation) {
  const double margin = kSameLength * length_;
  const ArcLength along(curve);
  for (LineConstraint& constraint : constraints_) {
    if (!constraint.weight) continue;
    const bool is_end = nearest_within(ends_, constraint.length, margin).has_value();
    if (!is_end && !nearest_within(held_, constraint.length, margin)) continue;
    const double certainty = *constraint.weight * deviation * deviation;
    const Point own = along.point_at(constraint.length);
    constraint.position = lerp(own, *constraint.position, certainty / (1 + certainty));
    constraint.weight.reset();
  }
}

std::vector<LineConstraint> LineConstraints::on(const PlainLine& line) const {
  const double end = arc_length(line.line);
  const double margin = kSameLength * end;
  const bool is_loop = line.line.closed;
  std::vector<Ranked> asked;
  // A line may go on past the seam of its curve.
  const auto ask = [&](LineConstraint constraint, Rank rank, double reach) {
    const double from_start = constraint.length - line.length_before;
    for (const double turn : {0.0, length_}) {
      if (turn > 0 && !closed_) break;
      constraint.length = from_start + turn;
      if (constraint.length < -reach || constraint.length > end + reach) continue;
      if (constraint.length <= reach) constraint.length = 0;
      if (constraint.length >= end - reach) constraint.length = end;
      if (is_loop && rank == Rank::kConstraint && constraint.length == end) continue;
      asked.push_back({constraint, rank});
    }
  };
  for (const LineConstraint& constraint : constraints_) ask(constraint, Rank::kConstraint, margin);
  for (const double length : held_) ask({length, {}, {}}, Rank::kHeld, 0);
  if (keep_ends_ && !is_loop) {
    asked.push_back({{0, {}, {}}, Rank::kEnd});
    asked.push_back({{end, {}, {}}, Rank::kEnd});
  }
  std::ranges::stable_sort(asked, {}, [](const Ranked& r) { return r.constraint.length; });

  std::vector<Ranked> kept;
  for (const Ranked& next : asked) {
    if (kept.empty() || next.constraint.length >= kept.back().constraint.length + margin) {
      kept.push_back(next);
    } else if (next.rank > kept.back().rank) {
      kept.back() = next;
    }
  }
  // The two ends of a closed line are one place.
  const auto begins_with_constraint = [&] {
    return kept.front().rank == Rank::kConstraint && kept.front().constraint.length == 0;
  };
  if (is_loop && kept.size() > 1 && begins_with_constraint() &&
      kept.back().constraint.length > end - margin) {
    kept.pop_back();
  }
  std::vector<LineConstraint> result;
  for (const Ranked& one : kept) result.push_back(one.constraint);
  return result;
}

}  // namespace libstyle
