// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/plain_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/polygon.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {
namespace {

// Over more than this share of its length a whole curve turns, a circle by 22 degrees.
constexpr double kLongestReach = 1.0 / 16;
constexpr double kTie = 1e-9;  // radians

class CornerFinder {
 public:
  CornerFinder(const Polyline& curve, double angle, double reach)
      : along_(curve), angle_(angle), reach_(std::min(reach, kLongestReach * along_.total())) {
    for (std::size_t i = 0; i < size(); ++i) turns_.push_back(is_end(i) ? 0 : turn_at(i));
  }

  std::vector<std::size_t> find() const {
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < size(); ++i) {
      if (turns_[i] > angle_ && (vertex_turn(i) > angle_ || is_sharpest_nearby(i))) {
        corners.push_back(i);
      }
    }
    return corners;
  }

 private:
  std::size_t size() const { return curve().points.size(); }
  const Polyline& curve() const { return along_.polyline(); }
  bool is_end(std::size_t i) const { return !curve().closed && (i == 0 || i + 1 == size()); }
  std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : size() - 1; }
  std::size_t after(std::size_t i) const { return i + 1 < size() ? i + 1 : 0; }

  double turn_between(Point from, std::size_t i, Point to) const {
    const Point middle = curve().points[i];
    return std::abs(turning_angle(middle - from, to - middle));
  }
  double turn_at(std::size_t i) const {
    const double place = along_.cumulative()[i];
    return turn_between(along_.point_at(place - reach_), i, along_.point_at(place + reach_));
  }
  double vertex_turn(std::size_t i) const {
    return turn_between(curve().points[before(i)], i, curve().points[after(i)]);
  }

  // A rounded corner is one corner, where it is sharpest.
  bool is_sharpest_nearby(std::size_t i) const {
    const auto beats = [&](std::size_t other, bool earlier) {
      return turns_[other] > turns_[i] + kTie || (earlier && turns_[other] > turns_[i] - kTie);
    };
    for (std::size_t k = i; !is_end(k);) {
      k = before(k);
      if (k == i || distance(curve().points[k], curve().points[i]) > reach_) break;
      if (beats(k, true)) return false;
    }
    for (std::size_t k = i; !is_end(k);) {
      k = after(k);
      if (k == i || distance(curve().points[k], curve().points[i]) > reach_) break;
      if (beats(k, false)) return false;
    }
    return true;
  }

  ArcLength along_;
  double angle_;
  double reach_;
  std::vector<double> turns_;  // seen over the reach, for each vertex
};

// The points from corner `first` to corner `last`, both included, going round if need be.
Polyline between(const Polyline& curve, std::size_t first, std::size_t last) {
  Polyline result;
  for (std::size_t i = first;; i = i + 1 < curve.points.size() ? i + 1 : 0) {
    result.points.push_back(curve.points[i]);
    if (i == last && result.points.size() > 1) return result;
  }
}

}  // namespace

std::vector<PlainLine> split_into_lines(const Polyline& given, std::optional<double> corner_angle,
                                        double reach) {
  const Polyline curve = without_repeated_points(given);
  if (curve.points.empty() || !(arc_length(curve) > 0)) return {};

  std::vector<std::size_t> corners;
  if (corner_angle) corners = CornerFinder(curve, *corner_angle, reach).find();
  if (corners.empty()) return {{curve, 0, false}};

  const std::vector<double> along = cumulative_lengths(curve);
  std::vector<PlainLine> lines;
  if (!curve.closed) lines.push_back({between(curve, 0, corners.front()), 0, false});
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    lines.push_back({between(curve, corners[i], corners[i + 1]), along[corners[i]], true});
  }
  const std::size_t end = curve.closed ? corners.front() : curve.points.size() - 1;
  lines.push_back({between(curve, corners.back(), end), along[corners.back()], true});
  return lines;
}

}  // namespace libstyle
