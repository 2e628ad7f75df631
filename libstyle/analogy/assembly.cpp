// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/assembly.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "libstyle/analogy/stitch.h"
#include "libstyle/analogy/warp.h"

namespace libstyle {
namespace {

constexpr double kStitchReach = 3;  // feature sizes
constexpr double kWarpWidth = 3;    // feature sizes

// The line that a walk is drawn along, in style coordinates.
struct Ground {
  const Sweep& line;
  const StyleGrid& grid;

  Vector to_page(Vector offset, double x) const {
    return grid.scale_at(x) * libstyle::to_page(offset, line.frame_at(grid.length_at(x)));
  }
};

// Offsets on the page at the coordinates, stitched where runs meet.
std::vector<Vector> stitched_offsets(const PlacedRuns& runs, const Ground& ground,
                                     std::span<const double> xs, double steps, double reach) {
  const bool closed = ground.line.closed();
  const std::size_t n = xs.size();
  std::vector<Vector> anchors(n), moves(closed ? n : n - 1);
  std::vector<double> gaps(moves.size());
  for (std::size_t i = 0; i < n; ++i) {
    anchors[i] = ground.to_page(runs.offset_at(runs.blend_at(xs[i]), xs[i]), xs[i]);
  }
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const double from = xs[i], to = i + 1 < n ? xs[i + 1] : xs[0] + steps;
    const PlacedRuns::Blend blend = runs.blend_at((from + to) / 2);
    // The frame at xs[0] is the one at `to` too when the curve closes.
    moves[i] = ground.to_page(runs.offset_at(blend, to), i + 1 < n ? to : xs[0]) -
               ground.to_page(runs.offset_at(blend, from), from);
    gaps[i] = to - from;
  }
  if (closed && n < 3) return anchors;
  return stitch(anchors, moves, gaps, reach, closed);
}

// The sample coordinates with the held ones among them, bit for bit.
std::vector<double> with_held(const std::vector<double>& xs, std::span<const double> held) {
  std::vector<double> result;
  auto next = held.begin();
  for (const double x : xs) {
    while (next != held.end() && *next < x - kSamePlace) result.push_back(*next++);
    const bool same = next != held.end() && *next <= x + kSamePlace;
    result.push_back(same ? *next++ : x);
  }
  result.insert(result.end(), next, held.end());
  return result;
}

// A closed line feels what is held also from the other side of its seam.
void hold(std::vector<Vector>& offsets, std::span<const double> xs, std::span<const double> held,
          double width, std::optional<double> period) {
  std::vector<WarpTarget> targets;
  for (const double x : held) {
    const auto i = static_cast<std::size_t>(std::ranges::lower_bound(xs, x) - xs.begin());
    targets.push_back({x, -offsets[i]});
    if (!period) continue;
    targets.push_back({x - *period, -offsets[i]});
    targets.push_back({x + *period, -offsets[i]});
  }
  const Warp warp(targets, width);
  for (std::size_t i = 0; i < xs.size(); ++i) offsets[i] += warp.at(xs[i]);
}

std::vector<std::vector<double>> copied_features(const Example& example, const PlacedRuns& runs,
                                                 const StyleGrid& grid,
                                                 std::span<const double> xs) {
  const std::span<const LineFeature> features = example.features();
  std::vector<std::vector<double>> result(features.size());
  if (features.empty()) return result;
  for (const double x : xs) {
    const std::vector<double> values = runs.features_at(runs.blend_at(x), x);
    for (std::size_t i = 0; i < features.size(); ++i) {
      const bool is_length = features[i].kind == FeatureKind::kLength;
      result[i].push_back(is_length ? grid.scale_at(x) * values[i] : values[i]);
    }
  }
  return result;
}

}  // namespace

DrawnLine draw_walk(const Example& example, const Sweep& line, const StyleGrid& grid,
                    std::span<const ChainState> walk, std::span<const double> held) {
  const std::vector<ChainRun> found = find_runs(example, walk);
  const PlacedRuns runs(example, found, grid.steps(), line.closed());
  const auto steps = static_cast<double>(grid.steps());
  const double feature = example.feature_along() / example.step();
  std::vector<double> xs = runs.sample_coordinates(steps);
  if (!line.closed()) xs.push_back(steps);
  xs = with_held(xs, held);

  const Ground ground{line, grid};
  std::vector<Vector> offsets = stitched_offsets(runs, ground, xs, steps, kStitchReach * feature);
  std::optional<double> period;
  if (line.closed()) period = steps;
  hold(offsets, xs, held, kWarpWidth * feature, period);

  DrawnLine drawn{{{}, line.closed()}, {}, copied_features(example, runs, grid, xs)};
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const bool is_held = std::ranges::binary_search(held, xs[i]);
    const bool is_end = !line.closed() && i + 1 == xs.size();
    drawn.lengths.push_back(is_end ? line.length() : grid.length_at(xs[i]));
    const Point place = line.point_at(drawn.lengths.back());
    drawn.curve.points.push_back(is_held ? place : place + offsets[i]);
  }
  return drawn;
}

}  // namespace libstyle
