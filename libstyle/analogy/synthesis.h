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
// Under AnalogyMethod::kGreedy the curve is made by the paper's own search instead
// (greedy/greedy_search.h), which comes out up to a sixth shorter or longer than was asked for.
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

#include "libstyle/analogy/example.h"
#include "libstyle/analogy/greedy/greedy_search.h"
#include "libstyle/analogy/jump_costs.h"
#include "libstyle/analogy/parameters.h"
#include "libstyle/analogy/runs.h"
#include "libstyle/analogy/style_summary.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

struct SynthesizedCurve {
  Polyline curve;                             // open; begins at the origin
  std::vector<std::vector<double>> features;  // for each feature of the example and each point
  std::vector<ChainRun> runs;                 // what it was copied from
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
  SynthesizedCurve draw(double length, std::uint64_t place, std::uint64_t variant = 0) const;

  // As for analogies.
  double longest_curve() const;

  const Example& example() const { return example_; }
  StyleSummary summary() const;

 private:
  SynthesizedCurve walk(double length, std::uint64_t place, std::uint64_t variant) const;
  ChainVariety variety() const;

  CurveAnalogyParameters asked_;
  CurveAnalogyParameters parameters_;  // with the feature size
  Example example_;
  JumpModel jumps_;
  std::optional<GreedySearch> search_;
};

}  // namespace libstyle
