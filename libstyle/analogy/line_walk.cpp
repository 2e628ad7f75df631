// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/line_walk.h"

#include <algorithm>
#include <utility>

#include "libstyle/analogy/living_walk.h"
#include "libstyle/analogy/shape_costs.h"
#include "libstyle/geometry/arc_length.h"

namespace libstyle {
namespace {

constexpr double kMeanRun = 8;  // feature sizes

// The longest run: a share of the example, but not less than so many feature sizes.
constexpr double kLongestRun = 0.2;
constexpr double kLeastLongestRun = 2.5;
constexpr double kRepeatFactor = 0.25;  // for each time that a place was used before on the line

// Feature sizes that change together from frame to frame. Given what is at both ends, pieces no
// longer than a run hardly ever change: the walk would have to jump away and back.
constexpr double kPiece = 20;

// Where a place is held, seen from the line, in the size of the example.
std::vector<HeldCosts::Place> offsets_of(std::span<const HeldPlace> held, const Sweep& line,
                                         const StyleGrid& grid) {
  std::vector<HeldCosts::Place> places;
  for (const auto& [x, position] : held) {
    places.push_back({x, {}});
    if (!position) continue;
    const double length = grid.length_at(x);
    places.back().offset =
        to_frame(*position - line.point_at(length), line.frame_at(length)) / grid.scale_at(x);
  }
  return places;
}

}  // namespace

LineWalk::LineWalk(const Example& example, const CurveAnalogyParameters& parameters)
    : example_(example),
      parameters_(parameters),
      jumps_(make_jump_model(example, {.mean_run = mean_run(), .ends_allowed = !samples()})),
      held_costs_(example) {}

double LineWalk::mean_run() const { return parameters_.mean_run.value_or(kMeanRun); }

WalkedLine LineWalk::draw(const Polyline& line, const StyleGrid& grid,
                          std::span<const LineConstraint> constraints,
                          const WalkSource& source) const {
  const std::vector<HeldPlace> held = held_places(line, grid, constraints);
  const double blur = grid.line_scale() * example_.feature_along();
  const Sweep sweep(line, parameters_.smoothing * blur, blur, parameters_.invariance);
  WalkedLine result;
  result.walk = samples() ? walk_randomly(sweep, grid, held, source) : walk_by_shape(sweep, grid);
  result.runs = find_runs(example_, result.walk);
  if (example_.has_strokes()) {
    result.strokes = draw_strokes(example_, sweep, grid, result.walk, held);
  } else {
    result.line = draw_walk(example_, sweep, grid, result.walk, held);
  }
  return result;
}

std::vector<HeldPlace> LineWalk::held_places(const Polyline& line, const StyleGrid& grid,
                                             std::span<const LineConstraint> constraints) const {
  const double end = arc_length(line);
  std::vector<HeldPlace> held;
  for (const LineConstraint& constraint : constraints) {
    const bool is_end = !line.closed && constraint.length == end;
    held.push_back(
        {is_end ? static_cast<double>(grid.steps()) : grid.coordinate_at(constraint.length),
         constraint.position});
  }
  return held;
}

// A jump lands most likely where closing the curve is easiest.
ChainState LineWalk::random_origin(const WalkSource& source) const {
  std::vector<double> arrivals(example_.state_count());
  for (std::size_t j = 0; j < arrivals.size(); ++j) arrivals[j] = jumps_.chain.landing[j] * 1e-9;
  for (const ChainRow& row : jumps_.chain.rows) {
    for (const ChainJump& jump : row.jumps) arrivals[jump.target] += jump.probability;
  }
  return static_cast<ChainState>(source.random.choose(source.first, arrivals));
}

std::vector<ChainState> LineWalk::walk_randomly(const Sweep& line, const StyleGrid& grid,
                                                std::span<const HeldPlace> held,
                                                const WalkSource& source) const {
  const std::vector<HeldCosts::Place> places = offsets_of(held, line, grid);
  ChainTask task;
  task.steps = grid.steps();
  task.costs = [&, steps = task.steps](std::size_t step, std::span<double> costs) {
    return held_costs_.add(step, steps, places, costs);
  };
  if (source.before.size() == task.steps) {
    const double piece = kPiece * example_.feature_along() / example_.step();
    const WalkChange change{1 - source.coherence, static_cast<std::size_t>(piece) + 1,
                            line.closed(), variety()};
    return changed_walk(jumps_.chain, task, source.before, change, source.random, source.first);
  }
  if (line.closed()) {
    task.origin = random_origin(source);
    task.next = task.origin;
  }
  return sample_chain(jumps_.chain, task, source.random, source.first, variety());
}

ChainVariety LineWalk::variety() const {
  const double least = kLeastLongestRun * example_.feature_along() / example_.step();
  const double share = kLongestRun * static_cast<double>(example_.state_count());
  return {static_cast<std::size_t>(std::max(share, least)), kRepeatFactor};
}

// A closed line is walked twice round first: where that passes half-way it no longer feels its
// ends, and the state there is where the closed walk begins.
std::vector<ChainState> LineWalk::walk_by_shape(const Sweep& line, const StyleGrid& grid) const {
  const ShapeCosts shape(example_, line, grid, parameters_.shape_weight, jumps_.tolerance);
  ChainTask task;
  task.steps = grid.steps();
  task.costs = [&](std::size_t step, std::span<double> costs) {
    shape.add(step % grid.steps(), costs);
    return true;
  };
  if (!line.closed()) return best_chain(jumps_.chain, task);
  task.steps = 2 * grid.steps();
  task.origin = best_chain(jumps_.chain, task)[grid.steps()];
  task.steps = grid.steps();
  task.next = task.origin;
  return best_chain(jumps_.chain, task);
}

}  // namespace libstyle
