// SPDX-License-Identifier: Apache-2.0
// What is asked of the places of a curve, brought to the lines between its corners.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "libstyle/analogy/curve_constraint.h"
#include "libstyle/analogy/plain_lines.h"
#include "libstyle/geometry/point.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

// A line is to pass here.
struct LineConstraint {
  double length = 0;               // along the line; exactly 0 or all of it at the ends
  std::optional<Point> position;   // unset: where the line is
  std::optional<double> weight{};  // > 0, 1/px^2; unset: hard
};

struct CurveConditions {
  std::span<const double> held;  // lengths along the curve, rising, at which it keeps its place
  std::span<const CurveConstraint> constraints;
  bool keep_ends = true;  // if not, `held`, ends and corners do not count
  // How far the curve strays from its ends, corners and held places when a soft constraint pulls
  // there, px.
  double deviation = 0;
};

// Places nearer to each other than this share of the length of a curve, or line, are one.
inline constexpr double kSameLength = 1e-6;

class LineConstraints {
 public:
  // `lines` are all those of the curve. Throws Error when a constraint is out of range, or when two
  // hard ones want one place of the curve at different positions.
  LineConstraints(const Polyline& curve, std::span<const PlainLine> lines,
                  const CurveConditions& conditions);

  // For one of the lines, by rising length, no two at the same place. Constraints come before the
  // places of ends and held places. A soft one at such a place makes it give way: it is hard then,
  // so that both lines of a corner still meet.
  std::vector<LineConstraint> on(const PlainLine& line) const;

  // Whether there are constraints, apart from ends and held places.
  bool any() const { return !constraints_.empty(); }

 private:
  void gather(const Polyline& curve, std::span<const PlainLine> lines,
              std::span<const CurveConstraint> constraints);
  void settle_at_held_places(const Polyline& curve, double deviation);

  double length_ = 0;
  bool closed_ = false;
  bool keep_ends_ = true;
  std::vector<double> held_;
  std::vector<double> ends_;                 // of open curves, and corners
  std::vector<LineConstraint> constraints_;  // lengths are along the curve
};

}  // namespace libstyle
