// SPDX-License-Identifier: Apache-2.0
// How much it would show if a copy of the example went on at another place.
//
// Two places of the filtered curve are compared by what surrounds them: 17 samples over two feature
// sizes to each side, weighted by a Gaussian, each the offset from the unfiltered curve and the
// tangent, both in the frame. Tangents count with the square of the feature size, which brings both
// to px^2. At the ends of a line the samples that exist decide. Features of the line, such as its
// width, count a little too, in units of their spread over the example, so that they do not leap.
// Where lines are drawn as several strokes, all lanes are compared, and the pen up in one place and
// down in the other counts.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/analogy/chain.h"
#include "libstyle/analogy/example.h"

namespace libstyle {

class JumpCosts {
 public:
  explicit JumpCosts(const Example& example);

  // The mean squared difference, px^2, between what surrounds the end of state `from` and what
  // surrounds the beginning of each state. `costs` has one slot for each state.
  void from_end_of(std::size_t from, std::span<double> costs) const;
  // The same for the beginning of `from`.
  void from_start_of(std::size_t from, std::span<double> costs) const;

 private:
  struct Window;

  void weigh_features();
  void append_components(std::vector<double>& components, const Lane& lane, double length) const;
  Window window_at(const ExampleLine& line, double length) const;
  void compare(const Window& window, std::span<double> costs) const;

  const Example& example_;
  std::vector<double> feature_weights_;  // px for a unit of each feature
  std::size_t components_;
  std::vector<double> windows_;  // [tap][component][state], at the beginnings of the states
  std::vector<double> present_;  // [tap][state]: 1 where the sample exists, else 0
};

// The chain over the states of an example, for runs of `mean_run` feature sizes on average.
//
// Jumps go to the best phase of every other place, at least two feature sizes away. A jump is as
// likely as exp(-cost / tolerance), where the tolerance, the cost of what still looks alike, is the
// 10 % quantile of the cost of the nearest other place: it calibrates itself. From a place without
// its like there are no jumps. Jumps into the last two feature sizes of a line would lead nowhere
// and do not happen, unless `ends_allowed`.
struct JumpModel {
  ChainModel chain;
  double tolerance = 0;  // px^2
};

JumpModel make_jump_model(const Example& example, double mean_run, bool ends_allowed);

}  // namespace libstyle
