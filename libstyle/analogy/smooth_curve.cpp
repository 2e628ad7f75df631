// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/smooth_curve.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "libstyle/geometry/cubic_fit.h"

namespace libstyle {
namespace {

constexpr double kGrid = 1e4;  // coordinates to a px

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

// The points from `first` to `last`, on round if the curve is closed.
Polyline stretch(const Polyline& curve, std::size_t first, std::size_t last) {
  Polyline result;
  const std::size_t n = curve.points.size();
  for (std::size_t i = first; i <= last; ++i) result.points.push_back(curve.points[i % n]);
  return result;
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

SmoothCurve smooth_curve(const StyledCurve& drawn, double total_length, double tolerance) {
  const std::size_t n = drawn.curve.points.size();
  const bool closed = drawn.curve.closed;
  std::vector<std::size_t> breaks = drawn.corners;
  SmoothCurve result;
  if (closed && breaks.empty()) {
    const CubicFit whole = fit_cubics(drawn.curve, {.tolerance = tolerance}, drawn.pinned);
    append_fit(result, whole, drawn.pinned);
    for (const std::size_t i : whole.points) result.lengths.push_back(drawn.lengths[i]);
    return result;
  }
  if (!closed && (breaks.empty() || breaks.front() != 0)) breaks.insert(breaks.begin(), 0);
  breaks.push_back(closed ? breaks.front() + n : n - 1);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const std::vector<std::size_t> pinned = pinned_on(drawn, breaks[k], breaks[k + 1]);
    const CubicFit part = fit_cubics(stretch(drawn.curve, breaks[k], breaks[k + 1]),
                                     {.tolerance = tolerance}, pinned);
    append_fit(result, part, pinned);
    for (std::size_t i = k == 0 ? 0 : 1; i < part.points.size(); ++i) {
      const std::size_t point = breaks[k] + part.points[i];
      result.lengths.push_back(drawn.lengths[point % n] + (point < n ? 0 : total_length));
    }
  }
  if (closed) result.path.close();
  return result;
}

}  // namespace libstyle
