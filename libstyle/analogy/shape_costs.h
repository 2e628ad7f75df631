// SPDX-License-Identifier: Apache-2.0
// How ill a place of the unfiltered example suits a place of the line to be drawn.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/analogy/example.h"
#include "libstyle/analogy/style_grid.h"
#include "libstyle/analogy/sweep.h"

namespace libstyle {

// Windows of two feature sizes to each side on A and B, in their frames: places relative to the
// middle, and directions weighted by the feature size. The ends of open lines belong together: a
// line begins best where an example begins and ends best where one ends, and what an example draws
// at its ends, such as the hook of a letter, does not belong in the middle of a line.
class ShapeCosts {
 public:
  // Costs are `weight` * squared difference, px^2, / (4 * tolerance): the tolerance of the jumps
  // (jump_costs.h) decides what is a large difference. The factor 1/4 was found by trial.
  ShapeCosts(const Example& example, const Sweep& line, const StyleGrid& grid, double weight,
             double tolerance);

  // Adds the cost of drawing `step` from each state.
  void add(std::size_t step, std::span<double> costs) const;

 private:
  std::vector<double> example_windows_;  // [component][state]
  std::vector<double> line_windows_;     // [step][component]
  std::vector<double> start_nearness_;   // [state]: 1 where a line begins, 0 away from there
  std::vector<double> end_nearness_;     // [state]
  std::size_t states_;
  std::size_t steps_;
  double factor_;
  double feature_steps_ = 0;  // of a feature size
  bool closed_ = false;
};

}  // namespace libstyle
