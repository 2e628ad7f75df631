// SPDX-License-Identifier: Apache-2.0
// Makes a new curve of a given length in the style of an example, without any line to draw along.
//
// Source: Hertzmann, Oliver, Curless and Seitz, "Curve Analogies", Eurographics Workshop on
// Rendering 2002, section 3.1: curve synthesis, the special case without A and B.
//
// Stages:
//  1. A' is cut into states of equal length along itself.                       example.h
//  2. Jumps between states cost what they show: the windows around both places
//     are compared by their tangents.                                           jump_costs.h
//  3. A random walk over the states goes on verbatim most of the time, jumps
//     where it shows least, and minds what it has used already.                 chain.h
//  4. The pieces are joined: each goes on where the last one ended, and in its
//     direction under Invariance::kRotate. Half a feature size to each side of
//     a jump the two fade into each other in their moves, so there is no seam
//     to mend.                                                                  runs.h
//
// Under constraints (section 3.2) several walks are drawn, aimed at the places where pieces keep
// their direction (walk_aim.h); of these the one that fits best is put where it fits best, turned
// too under Invariance::kRotate, and bent evenly between the constraints. Beyond them, forward and
// backward, it goes on as it was drawn. Soft constraints become hard ones at the places that they
// and a curve drawn without them agree on (soft_constraints.h).
//
// Under AnalogyMethod::kGreedy the curve is made by the paper's own search instead
// (greedy/greedy_search.h), which comes out up to a sixth shorter or longer than was asked for, and
// weighs constraints itself.
//
// Departures. The paper grows the curve sample by sample; its literal search copies without end
// where it finds an exact match, loops near the end of the example, and loses the fine levels
// (tests/bench/literal shows it). Here no run is longer than an eighth of the example, no jump
// leads into its last two feature sizes, and places that were used before are taken less gladly, so
// that most of the example comes to be seen and no repetition does.
//
// Guarantees: the same seed and place give the same curve; scaling, moving or (under
// Invariance::kRotate: turning) the example does the same to the curve. Cost: preparing O(n^2) in
// the states (at most 2048), drawing O(length / F) times O(states).
//
//   const CurveSynthesis style({&coast, 1}, parameters);
//   const Polyline another_coast = style.draw(2 * arc_length(coast), 0).curve;
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/analogy/chain.h"
#include "libstyle/analogy/curve_constraint.h"
#include "libstyle/analogy/example.h"
#include "libstyle/analogy/greedy/greedy_search.h"
#include "libstyle/analogy/jump_model.h"
#include "libstyle/analogy/parameters.h"
#include "libstyle/analogy/runs.h"
#include "libstyle/analogy/style_summary.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

struct SynthesizedCurve {
  Polyline curve;  // open; begins at the origin unless there are constraints
  std::vector<std::vector<double>> features;  // for each feature of the example and each point
  std::vector<ChainRun> runs;                 // what it was copied from
  std::vector<std::size_t> pinned{};          // points where constraints want them exactly, rising
  bool is_placed = false;                     // constraints say where it lies
};

class CurveSynthesis {
 public:
  // Of the parameters seed, invariance, scale, feature_size, samples and mean_run count, and those
  // of the search if that is the method. Throws Error when one is out of range or an example cannot
  // serve. Examples that close have no seam.
  CurveSynthesis(std::span<const Polyline> examples, const CurveAnalogyParameters& parameters);
  // The filtered curves of the pairs, with their features; not the further strokes.
  CurveSynthesis(std::span<const ExamplePair> examples, const CurveAnalogyParameters& parameters);

  // A curve of this length, px of the drawing: > 0 and at most longest_curve(). `place` tells
  // curves of one seed apart, `variant` is added to the seed. Throws Error for other lengths. Safe
  // to call from several threads.
  //
  // `constraints` are places that it passes exactly, or is drawn towards; t is a fraction of its
  // length before it is bent to them, so its own length is about what was asked for. Throws Error
  // when one is out of range, when they contradict each other, and when hard ones are farther apart
  // than the length between them.
  SynthesizedCurve draw(double length, std::uint64_t place, std::uint64_t variant = 0,
                        std::span<const CurveConstraint> constraints = {}) const;

  // As for analogies.
  double longest_curve() const;

  const Example& example() const { return example_; }
  StyleSummary summary() const;

 private:
  struct Task;

  SynthesizedCurve search(double length, std::uint64_t place, std::uint64_t variant,
                          std::span<const CurveConstraint> constraints) const;
  SynthesizedCurve walk(const Task& task, std::uint64_t first_place, const StepCosts& costs) const;
  SynthesizedCurve draw_through(const Task& task, std::span<const CurveConstraint> pins) const;
  std::vector<CurveConstraint> settled(const Task& task,
                                       std::vector<CurveConstraint> constraints) const;
  void put_in_place(SynthesizedCurve& drawn, std::span<const CurveConstraint> constraints) const;
  ChainVariety variety() const;

  CurveAnalogyParameters asked_;
  CurveAnalogyParameters parameters_;  // with the feature size
  Example example_;
  JumpModel jumps_;
  std::optional<GreedySearch> search_;
};

}  // namespace libstyle
