// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/rounded_corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/corners.h"
#include "libstyle/geometry/polygon.h"

namespace libstyle {
namespace {

constexpr double kLeastTurn = std::numbers::pi / 6;  // a corner of the plain line
constexpr double kReach = 1;        // feature sizes: how far from a corner it may be rounded
constexpr double kBendReach = 0.1;  // feature sizes over which a bend is measured
// Feature sizes: rounder is a bend of its own, sharper a corner that is kept.
constexpr double kMostBlur = 1, kLeastBlur = 0.1;
// Standard deviations from a corner up to which the line is blurred in full, and at all.
constexpr double kFullReach = 2.5, kWholeReach = 5;

// The turns of the filtered curve along its length, as often as it goes round near a corner.
class Turns {
 public:
  Turns(const SampledCurve& filtered, double plain_length, bool closed) {
    const std::vector<Point>& points = filtered.polyline.points;
    const std::vector<double> along = cumulative_lengths(filtered.polyline);
    for (const int turn : closed ? std::vector{-1, 0, 1} : std::vector{0}) {
      for (std::size_t i = closed ? 0 : 1; i + 1 < points.size(); ++i) {
        const Point before = points[i > 0 ? i - 1 : points.size() - 2];
        turns_.push_back({filtered.t[i] + turn * plain_length, along[i] + turn * along.back(),
                          turning_angle(points[i] - before, points[i + 1] - points[i])});
      }
    }
  }

  // The sharpest turn of the curve over kBendReach near a length of the plain line, radians.
  double sharpest(double length, double feature) const {
    double result = 0;
    const double reach = kBendReach * feature;
    for (auto i = std::ranges::lower_bound(turns_, length - kReach * feature, {}, &Turn::place);
         i != turns_.end() && i->place <= length + kReach * feature; ++i) {
      double sum = 0;
      for (auto k = i; k != turns_.end() && k->along < i->along + reach; ++k) sum += k->angle;
      result = std::max(result, std::abs(sum));
    }
    return result;
  }

 private:
  struct Turn {
    double place = 0;  // along the plain line, rising
    double along = 0;  // along the filtered curve, rising
    double angle = 0;  // radians
  };

  std::vector<Turn> turns_;
};

// The sigma with which a corner that turns by `whole` was blurred if it turns by at most `turn`
// over an arc length of `reach` now. With u = x / sigma, e = erf(u / sqrt 2) and a = whole / 2, the
// blurred corner has at x turned by atan(e tan a) from its middle, at a speed of
// |cos a, e sin a| (the velocity is the blurred step from one direction to the other).
double blur_between(double whole, double turn, double reach) {
  constexpr double kStep = 0.01;
  const double tangent = std::tan(turn / 2), whole_tangent = std::tan(whole / 2);
  if (!(turn < whole)) return 0;
  double arc = 0;
  for (double u = kStep / 2;; u += kStep) {
    const double e = std::erf(u / std::numbers::sqrt2);
    if (e * whole_tangent >= tangent || u > kFullReach) break;
    arc += kStep * std::hypot(std::cos(whole / 2), e * std::sin(whole / 2));
  }
  return arc > 0 ? reach / (2 * arc) : std::numeric_limits<double>::infinity();
}

}  // namespace

RoundedCorners::RoundedCorners(const Polyline& plain, const SampledCurve& filtered, double feature)
    : length_(arc_length(plain)), closed_(plain.closed) {
  const Turns turns(filtered, length_, closed_);
  const std::vector<double> lengths = cumulative_lengths(plain);
  const std::vector<Point>& points = plain.points;
  for (const std::size_t i : find_corners(plain, {kLeastTurn, kReach * feature / 2})) {
    const bool is_passed = lengths[i] >= filtered.t.front() && lengths[i] <= filtered.t.back();
    if (!closed_ && !is_passed) continue;
    const Point before = points[i > 0 ? i - 1 : points.size() - 1];
    const Point after = points[i + 1 < points.size() ? i + 1 : 0];
    const double turn = std::abs(turning_angle(points[i] - before, after - points[i]));
    const double sigma =
        std::min(kMostBlur * feature,
                 blur_between(turn, turns.sharpest(lengths[i], feature), kBendReach * feature));
    if (sigma > kLeastBlur * feature) corners_.push_back({lengths[i], sigma});
  }
}

double RoundedCorners::blur_at(double length) const {
  double most = 0;
  for (const Corner& corner : corners_) {
    double away = std::abs(length - corner.length);
    if (closed_) away = std::min(away, length_ - away);
    const double u =
        std::clamp((kWholeReach - away / corner.sigma) / (kWholeReach - kFullReach), 0.0, 1.0);
    most = std::max(most, corner.sigma * u * u * (3 - 2 * u));
  }
  return most;
}

}  // namespace libstyle
