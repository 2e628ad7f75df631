// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/feature_vertices.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/path_segments.h"

namespace libstyle {
namespace {

constexpr int kChords = 32;           // that the length of a segment is measured with
constexpr double kLeastPiece = 1e-4;  // of the parameter of a segment

// A point of the curve on its segment: value `index` of each feature, at the parameter t.
struct FeaturePoint {
  std::size_t index = 0;
  double t = 0;
};

// The parameters at which a segment has these shares of its length, which rise.
std::vector<double> parameters_at(const CubicBezier& curve, std::span<const double> shares) {
  Polyline chords;
  for (int i = 0; i <= kChords; ++i) {
    chords.points.push_back(point_at(curve, static_cast<double>(i) / kChords));
  }
  const ArcLength along(std::move(chords));
  std::vector<double> result;
  for (const double share : shares) {
    const PolylinePlace place = along.place_at(share * along.total());
    result.push_back((static_cast<double>(place.segment) + place.fraction) / kChords);
  }
  return result;
}

class SegmentCutter {
 public:
  SegmentCutter(const Polyline& curve, std::span<const std::vector<double>> features,
                std::span<const double> tolerances)
      : curve_(curve), features_(features), tolerances_(tolerances) {}

  // Where to cut the segment that was fitted from one point to another, going round if need be.
  std::vector<FeaturePoint> cuts(const CubicBezier& segment, std::size_t from, std::size_t to) {
    points_ = points_on(segment, from, to);
    std::vector<std::size_t> found;
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, points_.size() - 1}};
    while (!open.empty()) {
      const auto [first, last] = open.back();
      open.pop_back();
      const std::size_t worst = worst_between(first, last);
      if (worst == first) continue;
      found.push_back(worst);
      open.push_back({first, worst});
      open.push_back({worst, last});
    }
    std::ranges::sort(found);
    std::vector<FeaturePoint> result;
    for (const std::size_t i : found) result.push_back(points_[i]);
    return result;
  }

 private:
  std::vector<FeaturePoint> points_on(const CubicBezier& segment, std::size_t from,
                                      std::size_t to) const {
    const std::size_t n = curve_.points.size();
    const std::size_t last = curve_.closed && to <= from ? to + n : to;
    std::vector<double> shares = {0};
    for (std::size_t i = from; i < last; ++i) {
      shares.push_back(shares.back() + distance(curve_.points[i % n], curve_.points[(i + 1) % n]));
    }
    const double length = shares.back();
    for (double& share : shares) share = length > 0 ? share / length : 0;
    const std::vector<double> parameters = parameters_at(segment, shares);
    std::vector<FeaturePoint> result;
    for (std::size_t i = from; i <= last; ++i) result.push_back({i % n, parameters[i - from]});
    result.back().t = 1;
    return result;
  }

  // The point whose values are farthest beyond their tolerances; `first` if none is.
  std::size_t worst_between(std::size_t first, std::size_t last) const {
    std::size_t worst = first;
    double most = 1;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double before = points_[i].t - points_[first].t, after = points_[last].t - points_[i].t;
      if (before < kLeastPiece || after < kLeastPiece) continue;
      const double error = error_at(i, first, last, before / (before + after));
      if (error > most) std::tie(worst, most) = std::pair(i, error);
    }
    return worst;
  }

  // In tolerances.
  double error_at(std::size_t i, std::size_t first, std::size_t last, double share) const {
    double most = 0;
    for (std::size_t f = 0; f < features_.size(); ++f) {
      const auto value = [&](std::size_t point) { return features_[f][points_[point].index]; };
      const double off = std::abs(value(i) - std::lerp(value(first), value(last), share));
      if (off > 0) most = std::max(most, off / tolerances_[f]);
    }
    return most;
  }

  const Polyline& curve_;
  std::span<const std::vector<double>> features_;
  std::span<const double> tolerances_;
  std::vector<FeaturePoint> points_;
};

void append_piece(Path& path, const CubicBezier& piece, bool straight) {
  straight ? path.line_to(piece.p3) : path.cubic_to(piece.p1, piece.p2, piece.p3);
}

}  // namespace

CubicFit with_feature_vertices(CubicFit fit, const Polyline& curve,
                               std::span<const std::vector<double>> features,
                               std::span<const double> tolerances) {
  const std::vector<Subpath> whole = subpaths(fit.path);
  if (features.empty() || whole.empty() || whole.front().segments.empty()) return fit;
  SegmentCutter cutter(curve, features, tolerances);
  Path path;
  std::vector<std::size_t> points = {fit.points.front()};
  path.move_to(whole.front().segments.front().curve.p0);
  for (const PathSegment& segment : whole.front().segments) {
    if (segment.end_vertex < segment.start_vertex) break;  // the line that Z draws
    const std::size_t from = fit.points[segment.start_vertex], to = fit.points[segment.end_vertex];
    double t = 0;
    for (const FeaturePoint& cut : cutter.cuts(segment.curve, from, to)) {
      append_piece(path, piece_between(segment.curve, t, cut.t), segment.straight);
      points.push_back(cut.index);
      t = cut.t;
    }
    append_piece(path, t > 0 ? piece_between(segment.curve, t, 1) : segment.curve,
                 segment.straight);
    points.push_back(to);
  }
  if (whole.front().closed) path.close();
  fit.path = std::move(path);
  fit.points = std::move(points);
  return fit;
}

}  // namespace libstyle
