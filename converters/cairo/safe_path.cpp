// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/safe_path.h"

#include <algorithm>
#include <cmath>

#include "libstyle/geometry/bezier.h"
#include "libstyle/geometry/flatten.h"

namespace libstyle {
namespace {

constexpr double kFarthest = 1e12;  // px; keeps products of coordinates finite and 1e-4 px exact
constexpr double kFlatness = 0.05;  // px; half of Cairo's own tolerance
constexpr int kDeepest = 32;        // halvings: the error falls by 4 each, 1e12 / 4^32 < 1e-7

Box control_box(const CubicBezier& curve) {
  Box box;
  for (const Point p : {curve.p0, curve.p1, curve.p2, curve.p3}) box.include(p);
  return box;
}

bool meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

// A curve that misses the window may be its chord: both lie in one box outside, so neither the
// winding within nor what is stroked there changes.
void flatten_seen(const CubicBezier& curve, const Box& window, int depth,
                  std::vector<Point>& points) {
  const bool seen = meet(control_box(curve), window);
  if (depth == kDeepest || !seen || flattening_steps(curve, kFlatness) <= 1) {
    points.push_back(curve.p3);
    return;
  }
  const auto [first, second] = split_at(curve, 0.5);
  flatten_seen(first, window, depth + 1, points);
  flatten_seen(second, window, depth + 1, points);
}

struct FlatSubpath {
  std::vector<Point> points;
  bool closed = false;
};

std::vector<FlatSubpath> flattened(const Path& path, const Box& window) {
  std::vector<FlatSubpath> subpaths;
  const Point* next = path.points().data();
  for (const PathCommand command : path.commands()) {
    switch (command) {
      case PathCommand::kMove:
        subpaths.push_back({{bounded(next[0])}, false});
        break;
      case PathCommand::kLine:
        subpaths.back().points.push_back(bounded(next[0]));
        break;
      case PathCommand::kCubic:
        flatten_seen(
            {subpaths.back().points.back(), bounded(next[0]), bounded(next[1]), bounded(next[2])},
            window, 0, subpaths.back().points);
        break;
      case PathCommand::kClose:
        subpaths.back().closed = true;
        break;
    }
    next += point_count(command);
  }
  return subpaths;
}

// One side of the window: the half plane sign * coordinate <= limit.
struct Side {
  double Point::*coordinate;
  double sign;
  double limit;

  double excess(Point p) const { return sign * (p.*coordinate) - limit; }
};

std::vector<Point> cut_polygon(const std::vector<Point>& polygon, const Side& side) {
  std::vector<Point> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point from = polygon[i], to = polygon[(i + 1) % polygon.size()];
    const double before = side.excess(from), after = side.excess(to);
    if (before <= 0) result.push_back(from);
    if ((before < 0 && after > 0) || (before > 0 && after < 0)) {
      result.push_back(lerp(from, to, before / (before - after)));
    }
  }
  return result;
}

void cut_subpath(FlatSubpath subpath, const Box& window, const Transform& pen_from_device,
                 std::vector<StrokeRun>& runs) {
  if (subpath.closed || subpath.points.size() == 1) subpath.points.push_back(subpath.points[0]);
  double length = 0;
  bool joined = false;  // whether the last run reaches the start of this line
  for (std::size_t i = 0; i + 1 < subpath.points.size(); ++i) {
    const Point from = subpath.points[i], to = subpath.points[i + 1];
    const double line_length = norm(pen_from_device.linear(to - from));
    const auto range = visible_range(from, to, window);
    if (range) {
      if (!joined || range->first > 0) {
        runs.push_back({{}, length + range->first * line_length});
        runs.back().path.move_to(lerp(from, to, range->first));
      }
      runs.back().path.line_to(lerp(from, to, range->second));
    }
    joined = range && range->second == 1;
    length += line_length;
  }
}

}  // namespace

Point bounded(Point p) {
  return {std::clamp(p.x, -kFarthest, kFarthest), std::clamp(p.y, -kFarthest, kFarthest)};
}

// Liang and Barsky, 1984.
std::optional<std::pair<double, double>> visible_range(Point from, Point to, const Box& window) {
  double first = 0, last = 1;
  const Vector delta = to - from;
  const auto narrow = [&](double direction, double room) {
    if (direction == 0) return room >= 0;
    const double t = room / direction;
    if (direction < 0) {
      first = std::max(first, t);
    } else {
      last = std::min(last, t);
    }
    return first <= last;
  };
  const bool seen =
      narrow(-delta.x, from.x - window.low.x) && narrow(delta.x, window.high.x - from.x) &&
      narrow(-delta.y, from.y - window.low.y) && narrow(delta.y, window.high.y - from.y);
  return seen ? std::optional(std::pair(first, last)) : std::nullopt;
}

bool is_near(const Box& box, const Box& window) {
  return box.low.x >= window.low.x - kMargin && box.low.y >= window.low.y - kMargin &&
         box.high.x <= window.high.x + kMargin && box.high.y <= window.high.y + kMargin;
}

// Sutherland and Hodgman, 1974: each side moves what lies beyond it onto itself, so that winding
// numbers within the window stay as they were.
Path cut_fill(const Path& path, const Box& window) {
  const Side sides[] = {{&Point::x, -1, -window.low.x},
                        {&Point::x, 1, window.high.x},
                        {&Point::y, -1, -window.low.y},
                        {&Point::y, 1, window.high.y}};
  Path result;
  for (FlatSubpath& subpath : flattened(path, window)) {
    for (const Side& side : sides) subpath.points = cut_polygon(subpath.points, side);
    if (subpath.points.size() < 3) continue;
    result.move_to(subpath.points[0]);
    for (std::size_t i = 1; i < subpath.points.size(); ++i) result.line_to(subpath.points[i]);
    result.close();
  }
  return result;
}

std::vector<StrokeRun> cut_stroke(const Path& path, const Box& window,
                                  const Transform& pen_from_device) {
  std::vector<StrokeRun> runs;
  for (FlatSubpath& subpath : flattened(path, window)) {
    cut_subpath(std::move(subpath), window, pen_from_device, runs);
  }
  return runs;
}

}  // namespace libstyle
