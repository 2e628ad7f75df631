// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/assembly.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "libstyle/analogy/stitch.h"
#include "libstyle/analogy/warp.h"

namespace libstyle {
namespace {

constexpr double kStitchReach = 3;  // feature sizes
constexpr double kWarpWidth = 3;    // feature sizes
constexpr double kCrumb = 0.5;      // feature sizes: what is left of a stroke and not worth drawing
constexpr double kNearEnd = 0.5;  // feature sizes: a stroke that near to the end of a line is at it

// A stroke of a lane, and the line that it is drawn along, in style coordinates. Round a closed
// line a stroke may go on beyond the last step.
struct Ground {
  const Sweep& line;
  const StyleGrid& grid;
  const PlacedRuns& runs;
  std::size_t lane = 0;
  bool closed = false;  // the stroke, and with it the line

  double steps() const { return static_cast<double>(grid.steps()); }
  bool is_beyond(double x) const { return line.closed() && x >= steps(); }
  double in_range(double x) const { return is_beyond(x) ? x - steps() : x; }
  double length_at(double x) const {
    const bool is_end = !line.closed() && x >= steps();
    return is_end ? line.length() : grid.length_at(in_range(x));
  }
  Point place_at(double x) const { return line.point_at(length_at(x)); }

  Vector to_page(Vector offset, double x) const {
    return grid.scale_at(in_range(x)) * libstyle::to_page(offset, line.frame_at(length_at(x)));
  }
  Vector offset_at(const PlacedRuns::Blend& blend, double x) const {
    return runs.offset_at(blend, x, lane);
  }
  // How far the line is off itself where the style rounds its corners.
  Vector rounding_at(double x) const {
    const double blur = grid.scale_at(in_range(x)) * runs.blur_at(runs.blend_at(x, lane), x, lane);
    if (!(blur > 0)) return {};
    const double length = length_at(x);
    return line.point_at(length, blur) - line.point_at(length);
  }
};

// Offsets on the page at the coordinates, stitched where runs meet.
std::vector<Vector> stitched_offsets(const Ground& ground, std::span<const double> xs,
                                     double reach) {
  const std::size_t n = xs.size();
  std::vector<Vector> anchors(n), moves(ground.closed ? n : n - 1);
  std::vector<double> gaps(moves.size());
  for (std::size_t i = 0; i < n; ++i) {
    anchors[i] =
        ground.to_page(ground.offset_at(ground.runs.blend_at(xs[i], ground.lane), xs[i]), xs[i]);
  }
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const double from = xs[i], to = i + 1 < n ? xs[i + 1] : xs[0] + ground.steps();
    const PlacedRuns::Blend blend = ground.runs.blend_at((from + to) / 2, ground.lane);
    // The frame at xs[0] is the one at `to` too when the curve closes.
    moves[i] = ground.to_page(ground.offset_at(blend, to), i + 1 < n ? to : xs[0]) -
               ground.to_page(ground.offset_at(blend, from), from);
    gaps[i] = to - from;
  }
  if (ground.closed && n < 3) return anchors;
  return stitch(anchors, moves, gaps, reach, ground.closed);
}

// Adds to each offset how far the line is off itself where the style rounds its corners.
void round_corners(std::vector<Vector>& offsets, const Ground& ground, std::span<const double> xs) {
  for (std::size_t i = 0; i < xs.size(); ++i) offsets[i] += ground.rounding_at(xs[i]);
}

// The sample coordinates with the held ones among them, bit for bit.
std::vector<double> with_held(const std::vector<double>& xs, std::span<const HeldPlace> held) {
  std::vector<double> result;
  auto next = held.begin();
  for (const double x : xs) {
    while (next != held.end() && next->x < x - kSamePlace) result.push_back(next++->x);
    const bool same = next != held.end() && next->x <= x + kSamePlace;
    result.push_back(same ? next++->x : x);
  }
  while (next != held.end()) result.push_back(next++->x);
  return result;
}

// A closed line feels what is held also from the other side of its seam.
void hold(std::vector<Vector>& offsets, std::span<const double> xs, const Ground& ground,
          std::span<const HeldPlace> held, double width, std::optional<double> period) {
  std::vector<WarpTarget> targets;
  for (const auto& [x, position] : held) {
    const auto i = static_cast<std::size_t>(std::ranges::lower_bound(xs, x) - xs.begin());
    Vector move = -offsets[i];
    if (position) move += *position - ground.place_at(x);
    targets.push_back({x, move});
    if (!period) continue;
    targets.push_back({x - *period, move});
    targets.push_back({x + *period, move});
  }
  const Warp warp(targets, width);
  for (std::size_t i = 0; i < xs.size(); ++i) offsets[i] += warp.at(xs[i]);
}

std::vector<std::vector<double>> copied_features(const Example& example, const Ground& ground,
                                                 std::span<const double> xs) {
  const std::span<const LineFeature> features = example.features();
  std::vector<std::vector<double>> result(features.size());
  if (features.empty()) return result;
  for (const double x : xs) {
    const std::vector<double> values =
        ground.runs.features_at(ground.runs.blend_at(x, ground.lane), x, ground.lane);
    const double scale = ground.grid.scale_at(ground.in_range(x));
    for (std::size_t i = 0; i < features.size(); ++i) {
      const bool is_length = features[i].kind == FeatureKind::kLength;
      result[i].push_back(is_length ? scale * values[i] : values[i]);
    }
  }
  return result;
}

// A stroke through the coordinates, moved to the held places.
DrawnLine draw_stroke(const Example& example, const Ground& ground, std::vector<double> xs,
                      std::span<const HeldPlace> held) {
  const double feature = example.feature_along() / example.step();
  xs = with_held(xs, held);
  std::vector<Vector> offsets = stitched_offsets(ground, xs, kStitchReach * feature);
  round_corners(offsets, ground, xs);
  std::optional<double> period;
  if (ground.closed) period = ground.steps();
  hold(offsets, xs, ground, held, kWarpWidth * feature, period);

  DrawnLine drawn{{{}, ground.closed}, {}, copied_features(example, ground, xs)};
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const double seam = ground.is_beyond(xs[i]) ? ground.line.length() : 0;
    drawn.lengths.push_back(ground.length_at(xs[i]) + seam);
    const Point place = ground.place_at(xs[i]);
    const auto at = std::ranges::lower_bound(held, xs[i], {}, &HeldPlace::x);
    const bool is_held = at != held.end() && at->x == xs[i];
    drawn.curve.points.push_back(is_held ? at->position.value_or(place) : place + offsets[i]);
    if (is_held) drawn.pinned.push_back(i);
  }
  return drawn;
}

// ---- Lines of several strokes -------------------------------------------------------------------

// What is that near the end of a line reaches it.
std::vector<Lane::Stroke> reaching_ends(std::vector<Lane::Stroke> strokes, const Ground& ground,
                                        double near) {
  if (strokes.empty() || ground.line.closed()) return strokes;
  if (strokes.front().begin < near) strokes.front().begin = 0;
  if (strokes.back().end > ground.steps() - near) strokes.back().end = ground.steps();
  return strokes;
}

// The coordinates of a lane that lie on a stroke, and its ends.
std::vector<double> coordinates_on(const Lane::Stroke& stroke, std::span<const double> all,
                                   const Ground& ground) {
  std::vector<double> result = {stroke.begin};
  for (const double turn : {0.0, ground.steps()}) {
    for (const double x : all) {
      if (x + turn > stroke.begin + kSamePlace && x + turn < stroke.end - kSamePlace) {
        result.push_back(x + turn);
      }
    }
  }
  result.push_back(stroke.end);
  return result;
}

struct LaneStroke {
  Ground ground;
  std::vector<double> xs;
  std::vector<HeldPlace> held;
};

// The stroke that passes nearest to a place has to pass it exactly.
void hold_nearest(std::span<LaneStroke> strokes, const HeldPlace& place) {
  LaneStroke* nearest = nullptr;
  double least = 0, x = 0;
  for (LaneStroke& stroke : strokes) {
    for (const double turn : {0.0, stroke.ground.steps()}) {
      const double own = place.x + turn;
      if (own < stroke.xs.front() - kSamePlace || own > stroke.xs.back() + kSamePlace) continue;
      if (turn > 0 && !stroke.ground.line.closed()) continue;
      const Ground& ground = stroke.ground;
      const Vector offset = ground.offset_at(ground.runs.blend_at(own, ground.lane), own);
      Vector miss = ground.to_page(offset, own) + ground.rounding_at(own);
      if (place.position) miss -= *place.position - ground.place_at(own);
      const double off = squared_norm(miss);
      if (nearest && off >= least) continue;
      nearest = &stroke;
      least = off;
      x = own;
    }
  }
  if (nearest) nearest->held.push_back({x, place.position});
}

}  // namespace

DrawnLine draw_walk(const Example& example, const Sweep& line, const StyleGrid& grid,
                    std::span<const ChainState> walk, std::span<const HeldPlace> held) {
  const PlacedRuns runs(example, find_runs(example, walk), grid.steps(), line.closed());
  const Ground ground{line, grid, runs, 0, line.closed()};
  std::vector<double> xs = runs.sample_coordinates(ground.steps());
  if (!line.closed()) xs.push_back(ground.steps());
  return draw_stroke(example, ground, std::move(xs), held);
}

std::vector<DrawnLine> draw_strokes(const Example& example, const Sweep& line,
                                    const StyleGrid& grid, std::span<const ChainState> walk,
                                    std::span<const HeldPlace> held) {
  const PlacedRuns runs(example, find_runs(example, walk), grid.steps(), line.closed());
  const double feature = example.feature_along() / example.step();
  std::vector<LaneStroke> strokes;
  for (std::size_t lane = 0; lane < example.lane_count(); ++lane) {
    Ground ground{line, grid, runs, lane, false};
    const std::vector<double> all = runs.sample_coordinates(ground.steps(), lane);
    for (const Lane::Stroke& stroke : reaching_ends(
             runs.strokes(ground.steps(), lane, kCrumb * feature), ground, kNearEnd * feature)) {
      ground.closed = line.closed() && stroke.begin == 0 && stroke.end == ground.steps();
      std::vector<double> xs = ground.closed ? all : coordinates_on(stroke, all, ground);
      strokes.push_back({ground, std::move(xs), {}});
    }
  }
  for (const HeldPlace& place : held) hold_nearest(strokes, place);
  std::vector<DrawnLine> result;
  for (LaneStroke& stroke : strokes) {
    std::ranges::sort(stroke.held, {}, &HeldPlace::x);
    result.push_back(draw_stroke(example, stroke.ground, std::move(stroke.xs), stroke.held));
  }
  return result;
}

}  // namespace libstyle
