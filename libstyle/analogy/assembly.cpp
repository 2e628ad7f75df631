// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/assembly.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "libstyle/analogy/stitch.h"
#include "libstyle/analogy/warp.h"

namespace libstyle {
namespace {

constexpr double kFade = 0.5;        // feature sizes to each side of a jump
constexpr double kStitchReach = 3;   // feature sizes
constexpr double kWarpWidth = 3;     // feature sizes
constexpr double kSamePlace = 1e-9;  // steps

// The runs of a walk as a function of the style coordinate.
class RunPlacer {
 public:
  RunPlacer(const Example& example, std::span<const ChainRun> runs, std::size_t steps, bool closed)
      : example_(example) {
    const auto total = static_cast<double>(steps);
    if (closed) add(runs.back(), -total);
    for (const ChainRun& run : runs) add(run, 0);
    if (closed) add(runs.front(), total);
    const double fade = kFade * example.feature_along() / example.step();
    for (std::size_t i = 0; i + 1 < placed_.size(); ++i) {
      placed_[i].fade_out = std::min({fade, placed_[i].size() / 2, placed_[i + 1].size() / 2});
    }
  }

  // Which runs meet at x, and how much of the right one there is.
  struct Blend {
    std::size_t left = 0, right = 0;
    double right_share = 0;
  };

  Blend blend_at(double x) const {
    const auto next = std::ranges::upper_bound(placed_, x, {}, &Placed::begin);
    const auto i =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, next - placed_.begin() - 1));
    if (i > 0 && x - placed_[i].begin < placed_[i - 1].fade_out) return fade(i - 1, x);
    if (i + 1 < placed_.size() && placed_[i].end - x < placed_[i].fade_out) return fade(i, x);
    return {i, i, 0};
  }

  Vector offset_at(const Blend& blend, double x) const {
    const Vector left = offset_of(placed_[blend.left], x);
    if (blend.left == blend.right) return left;
    return lerp(left, offset_of(placed_[blend.right], x), blend.right_share);
  }

  // Coordinates from 0 to below `steps` at which the example has samples, or one run follows
  // another; rising, and never closer than kSamePlace.
  std::vector<double> sample_coordinates(double steps) const {
    std::vector<double> result;
    for (const Placed& run : placed_) {
      if (run.end <= 0 || run.begin >= steps) continue;
      result.push_back(run.begin);
      const auto samples = run.line->samples();
      auto at = std::ranges::upper_bound(samples, run.length, {}, &ExampleLine::Sample::length);
      for (; at != samples.end(); ++at) {
        const double x = run.begin + (at->length - run.length) / example_.step();
        if (x >= run.end - kSamePlace) break;
        if (x > result.back() + kSamePlace) result.push_back(x);
      }
    }
    return result;
  }

 private:
  struct Placed {
    double begin = 0, end = 0;  // coordinates
    const ExampleLine* line = nullptr;
    double length = 0;    // along the example at `begin`
    double fade_out = 0;  // half the width of the fade into the next run

    double size() const { return end - begin; }
  };

  void add(const ChainRun& run, double shift) {
    const double begin = static_cast<double>(run.first) + shift;
    placed_.push_back({begin, begin + static_cast<double>(run.steps), &example_.line(run.origin),
                       example_.length_of(run.origin)});
  }

  Blend fade(std::size_t left, double x) const {
    const double half = placed_[left].fade_out;
    const double u = std::clamp((x - placed_[left].end + half) / (2 * half), 0.0, 1.0);
    return {left, left + 1, u * u * (3 - 2 * u)};
  }

  Vector offset_of(const Placed& run, double x) const {
    return run.line->at(run.length + (x - run.begin) * example_.step()).offset;
  }

  const Example& example_;
  std::vector<Placed> placed_;
};

// The line that a walk is drawn along, in style coordinates.
struct Ground {
  const Sweep& line;
  const StyleGrid& grid;

  Vector to_page(Vector offset, double x) const {
    return grid.scale_at(x) * libstyle::to_page(offset, line.frame_at(grid.length_at(x)));
  }
};

// Offsets on the page at the coordinates, stitched where runs meet.
std::vector<Vector> stitched_offsets(const RunPlacer& runs, const Ground& ground,
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
    const RunPlacer::Blend blend = runs.blend_at((from + to) / 2);
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

}  // namespace

std::vector<ChainRun> find_runs(const Example& example, std::span<const ChainState> walk) {
  std::vector<ChainRun> runs;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const bool goes_on = i > 0 && walk[i] == walk[i - 1] + 1 && example.has_next(walk[i - 1]);
    if (!goes_on) runs.push_back({i, 0, walk[i]});
    ++runs.back().steps;
  }
  return runs;
}

DrawnLine draw_walk(const Example& example, const Sweep& line, const StyleGrid& grid,
                    std::span<const ChainState> walk, std::span<const double> held) {
  const std::vector<ChainRun> found = find_runs(example, walk);
  const RunPlacer runs(example, found, grid.steps(), line.closed());
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

  DrawnLine drawn{{{}, line.closed()}, {}};
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
