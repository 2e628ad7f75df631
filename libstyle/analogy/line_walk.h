// SPDX-License-Identifier: Apache-2.0
// Draws lines by a walk over the states of an example: stages 3, 5 and 6 of curve_analogy.h.
//
// With shape_weight 0 the walk is sampled from the chain, under the condition that it comes near
// the places that are held; with shape_weight > 0 it is the best one, which suits the shape of the
// line. A walk of the frame before is changed piece by piece instead (living_walk.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libstyle/analogy/assembly.h"
#include "libstyle/analogy/example.h"
#include "libstyle/analogy/held_costs.h"
#include "libstyle/analogy/jump_model.h"
#include "libstyle/analogy/line_constraints.h"
#include "libstyle/analogy/parameters.h"
#include "libstyle/analogy/style_grid.h"
#include "libstyle/base/random.h"

namespace libstyle {

// Where the randomness of a line comes from, and what it was in the frame before.
struct WalkSource {
  const RandomStream& random;
  std::uint64_t first = 0;             // of its numbers
  std::span<const ChainState> before;  // empty: there is no walk to change
  double coherence = 0;
};

struct WalkedLine {
  DrawnLine line;  // where the style draws strokes, the plain line
  std::vector<DrawnLine> strokes;
  std::vector<ChainRun> runs;
  std::vector<ChainState> walk;
};

class LineWalk {
 public:
  // `example` outlives it.
  LineWalk(const Example& example, const CurveAnalogyParameters& parameters);

  // `constraints` by rising length, all of them hard.
  WalkedLine draw(const Polyline& line, const StyleGrid& grid,
                  std::span<const LineConstraint> constraints, const WalkSource& source) const;

  const JumpModel& jumps() const { return jumps_; }
  double mean_run() const;  // feature sizes
  // The most states that a sampled walk copies in one go; 0: any number.
  std::size_t longest_run() const { return samples() ? variety().longest_run : 0; }

 private:
  bool samples() const { return parameters_.shape_weight == 0; }
  ChainVariety variety() const;
  std::vector<HeldPlace> held_places(const Polyline& line, const StyleGrid& grid,
                                     std::span<const LineConstraint> constraints) const;
  std::vector<ChainState> walk_randomly(const Sweep& line, const StyleGrid& grid,
                                        std::span<const HeldPlace> held,
                                        const WalkSource& source) const;
  std::vector<ChainState> walk_by_shape(const Sweep& line, const StyleGrid& grid) const;
  ChainState random_origin(const WalkSource& source) const;

  const Example& example_;
  CurveAnalogyParameters parameters_;
  JumpModel jumps_;
  HeldCosts held_costs_;
};

}  // namespace libstyle
