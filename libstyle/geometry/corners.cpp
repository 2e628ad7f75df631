// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/corners.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/polygon.h"

namespace libstyle {
namespace {

void validate(const Polyline& polyline, const CornerParams& params) {
  if (!(params.angle >= 0 && params.angle <= std::numbers::pi)) {
    throw Error("corners: angle must be between 0 and pi");
  }
  if (!(params.reach > 0) || !std::isfinite(params.reach)) {
    throw Error("corners: reach must be a positive number");
  }
  if (!std::isfinite(arc_length(polyline))) {
    throw Error("corners: a point is not finite or too far away to measure");
  }
}

// A curve looked at from one of its vertices.
class CornerFinder {
 public:
  CornerFinder(const Polyline& polyline, const CornerParams& params)
      : along_(polyline), params_(params) {}

  std::vector<std::size_t> find() const {
    const std::vector<double> turns = chord_turns();
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < turns.size(); ++i) {
      if (is_peak(turns, i) && is_corner(i)) corners.push_back(i);
    }
    return corners;
  }

 private:
  // Chords of a noisy corner may turn somewhat less than its sides.
  static constexpr double kPeakShare = 0.7;
  // How many standard errors a turn must be above the angle. On noisy squares and circles 3 gives a
  // third of the false corners of 0 and loses no true ones.
  static constexpr double kCertainty = 3;
  // Samples on either side for the two models.
  static constexpr int kSamples = 8;

  bool closed() const { return along_.polyline().closed; }
  double length_at(std::size_t vertex) const { return along_.cumulative()[vertex]; }

  // How far one may look back and ahead from a length.
  double reach_before(double length) const {
    return std::min(params_.reach, closed() ? along_.total() / 3 : length);
  }
  double reach_after(double length) const {
    return std::min(params_.reach, closed() ? along_.total() / 3 : along_.total() - length);
  }

  // The absolute turn between chords within reach, 0 where there is too little curve.
  std::vector<double> chord_turns() const {
    const std::vector<Point>& points = along_.polyline().points;
    std::vector<double> turns(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0 && points[i] == points[i - 1]) continue;
      const double length = length_at(i);
      const double before = reach_before(length), after = reach_after(length);
      if (std::min(before, after) < 0.25 * params_.reach) continue;
      turns[i] = std::abs(turning_angle(points[i] - along_.point_at(length - before),
                                        along_.point_at(length + after) - points[i]));
    }
    return turns;
  }

  // The sharpest turn within half the reach, the first of equals.
  bool is_peak(const std::vector<double>& turns, std::size_t i) const {
    return turns[i] > kPeakShare * params_.angle && !is_beaten(turns, i, false) &&
           !is_beaten(turns, i, true);
  }

  bool is_beaten(const std::vector<double>& turns, std::size_t i, bool ahead) const {
    const std::size_t count = turns.size();
    const std::size_t steps = closed() ? count - 1 : ahead ? count - 1 - i : i;
    for (std::size_t step = 1; step <= steps; ++step) {
      const std::size_t j = (ahead ? i + step : i + count - step) % count;
      double gap = ahead ? length_at(j) - length_at(i) : length_at(i) - length_at(j);
      if (gap < 0) gap += along_.total();
      if (gap > 0.5 * params_.reach) return false;
      if (turns[j] > turns[i] || (turns[j] == turns[i] && j < i)) return true;
    }
    return false;
  }

  // Whether two straight pieces fit better than a parabola, and how they turn.
  bool is_corner(std::size_t i) const {
    constexpr int kRows = 2 * kSamples + 1;
    Eigen::Matrix<double, kRows, 3> pieces, parabola;
    Eigen::Matrix<double, kRows, 2> points;
    const double length = length_at(i);
    // Lengths in units of the longer side: equations of like size whatever the curve's unit.
    const double unit = std::max(reach_before(length), reach_after(length));
    const double before = reach_before(length) / unit, after = reach_after(length) / unit;
    for (int row = 0; row < kRows; ++row) {
      const double share = static_cast<double>(row - kSamples) / kSamples;
      const double u = share * (share < 0 ? before : after);
      const Point p = along_.point_at(length + u * unit) - along_.polyline().points[i];
      pieces.row(row) << 1, std::min(u, 0.0), std::max(u, 0.0);
      parabola.row(row) << 1, u, u * u;
      points.row(row) << p.x, p.y;
    }
    const Eigen::Matrix<double, 3, 2> sides = pieces.colPivHouseholderQr().solve(points);
    const Eigen::Matrix<double, 3, 2> bend = parabola.colPivHouseholderQr().solve(points);
    const double turn =
        std::abs(turning_angle({sides(1, 0), sides(1, 1)}, {sides(2, 0), sides(2, 1)}));
    const double pieces_error = (pieces * sides - points).squaredNorm();
    const double parabola_error = (parabola * bend - points).squaredNorm();
    // The standard error of the angle between two fitted lines of kSamples points each, for what
    // noise the misfit shows.
    const double noise = std::sqrt(pieces_error / (2 * kRows - 6)) / unit;
    const double uncertainty = noise * std::sqrt(6.0 / kSamples) / std::min(before, after);
    return turn > params_.angle + kCertainty * uncertainty && pieces_error <= parabola_error;
  }

  ArcLength along_;
  CornerParams params_;
};

}  // namespace

std::vector<std::size_t> find_corners(const Polyline& polyline, const CornerParams& params) {
  validate(polyline, params);
  if (polyline.points.size() < 3) return {};
  return CornerFinder(polyline, params).find();
}

}  // namespace libstyle
