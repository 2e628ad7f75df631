// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/smooth_curve.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "libstyle/analogy/feature_vertices.h"
#include "libstyle/geometry/cubic_fit.h"

namespace libstyle {
namespace {

constexpr double kGrid = 1e4;               // coordinates to a px
constexpr double kFitTolerance = 0.01;      // of a feature size
constexpr double kFeatureTolerance = 0.02;  // of the extent of a feature

Point on_grid(Point p) {
  const Point rounded = {std::round(p.x * kGrid) / kGrid, std::round(p.y * kGrid) / kGrid};
  return is_finite(rounded) ? rounded : p;
}

// Appends a fitted path without its first move, if it continues what is there, and with all points
// but the ends and the points `exact` on the grid.
void append_fit(SmoothCurve& result, const CubicFit& fit, std::span<const std::size_t> exact) {
  std::size_t next = 0, vertex = 0;
  const std::span<const Point> points = fit.path.points();
  const auto take_control = [&] { return on_grid(points[next++]); };
  const auto take_vertex = [&] {
    const bool end = next == 0 || next + 1 == points.size();
    const bool is_exact = end || std::ranges::binary_search(exact, fit.points[vertex]);
    ++vertex;
    const Point p = points[next++];
    return is_exact ? p : on_grid(p);
  };
  for (const PathCommand command : fit.path.commands()) {
    if (command == PathCommand::kMove) {
      const Point start = take_vertex();
      if (result.path.empty()) result.path.move_to(start);
    } else if (command == PathCommand::kLine) {
      result.path.line_to(take_vertex());
    } else if (command == PathCommand::kCubic) {
      const Point control1 = take_control(), control2 = take_control();
      result.path.cubic_to(control1, control2, take_vertex());
    } else {
      result.path.close();
    }
  }
}

// What is between two points of a curve.
struct Stretch {
  Polyline curve;
  std::vector<std::vector<double>> features;
};

// From `first` to `last`, on round if the curve is closed.
Stretch stretch(const StyledCurve& drawn, std::size_t first, std::size_t last) {
  Stretch result;
  const std::size_t n = drawn.curve.points.size();
  for (std::size_t i = first; i <= last; ++i) {
    result.curve.points.push_back(drawn.curve.points[i % n]);
  }
  for (const std::vector<double>& values : drawn.features) {
    std::vector<double>& own = result.features.emplace_back();
    for (std::size_t i = first; i <= last; ++i) own.push_back(values[i % n]);
  }
  return result;
}

CubicFit fit(const Polyline& curve, std::span<const std::vector<double>> features,
             const FitTolerances& tolerances, std::span<const std::size_t> pinned) {
  return with_feature_vertices(fit_cubics(curve, {.tolerance = tolerances.distance}, pinned), curve,
                               features, tolerances.features);
}

void append_features(SmoothCurve& result, const StyledCurve& drawn, std::size_t point) {
  result.features.resize(drawn.features.size());
  for (std::size_t i = 0; i < drawn.features.size(); ++i) {
    result.features[i].push_back(drawn.features[i][point]);
  }
}

// The points that the fit of a stretch has to pass exactly, counted from its first.
std::vector<std::size_t> pinned_on(const StyledCurve& drawn, std::size_t first, std::size_t last) {
  std::vector<std::size_t> result;
  for (const std::size_t turn : {std::size_t{0}, drawn.curve.points.size()}) {
    for (const std::size_t i : drawn.pinned) {
      if (i + turn >= first && i + turn <= last) result.push_back(i + turn - first);
    }
  }
  return result;
}

}  // namespace

FitTolerances fit_tolerances(const Example& example, double scale) {
  FitTolerances result{kFitTolerance * example.feature_size() * scale, {}};
  for (std::size_t i = 0; i < example.features().size(); ++i) {
    const bool is_length = example.features()[i].kind == FeatureKind::kLength;
    result.features.push_back(kFeatureTolerance * example.statistics(i).extent *
                              (is_length ? scale : 1));
  }
  return result;
}

SmoothCurve smooth_curve(const StyledCurve& drawn, double total_length,
                         const FitTolerances& tolerances) {
  const std::size_t n = drawn.curve.points.size();
  const bool closed = drawn.curve.closed;
  std::vector<std::size_t> breaks = drawn.corners;
  SmoothCurve result;
  if (closed && breaks.empty()) {
    const CubicFit whole = fit(drawn.curve, drawn.features, tolerances, drawn.pinned);
    append_fit(result, whole, drawn.pinned);
    for (const std::size_t i : whole.points) {
      result.lengths.push_back(drawn.lengths[i]);
      append_features(result, drawn, i);
    }
    return result;
  }
  if (!closed && (breaks.empty() || breaks.front() != 0)) breaks.insert(breaks.begin(), 0);
  breaks.push_back(closed ? breaks.front() + n : n - 1);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const auto [curve, features] = stretch(drawn, breaks[k], breaks[k + 1]);
    const std::vector<std::size_t> pinned = pinned_on(drawn, breaks[k], breaks[k + 1]);
    const CubicFit part = fit(curve, features, tolerances, pinned);
    append_fit(result, part, pinned);
    for (std::size_t i = k == 0 ? 0 : 1; i < part.points.size(); ++i) {
      const std::size_t point = breaks[k] + part.points[i];
      result.lengths.push_back(drawn.lengths[point % n] + (point < n ? 0 : total_length));
      append_features(result, drawn, point % n);
    }
  }
  if (closed) result.path.close();
  return result;
}

}  // namespace libstyle
