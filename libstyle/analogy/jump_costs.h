// SPDX-License-Identifier: Apache-2.0
// How much it would show if a copy of the example went on at another place.
//
// Two places of the filtered curve are compared by what surrounds them: samples over two feature
// sizes to each side, about four a feature size, weighted by a Gaussian, each the offset from the
// unfiltered curve and the tangent, both in the frame. Tangents count with the square of the
// feature size, which brings both to px^2. At the ends of a line the samples that exist decide.
// Features of the line, such as its width, count a little too, in units of their spread over the
// example, so that they do not leap. Where lines are drawn as several strokes, all lanes are
// compared, and the pen up in one place and down in the other counts.
//
// All places are compared with all others. Samples lie on a grid of which the beginnings of the
// states are a part, so that the sample o behind place j is also the one o - 1 behind place j + 1:
// each pair of samples is compared once, and the window is a filter along the diagonals of that
// table. (Schödl, Szeliski, Salesin and Essa compare frames so in "Video textures", SIGGRAPH 2000,
// section 3.) Cost: O(n^2) in the states, with some 50 operations a pair.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "libstyle/analogy/example.h"

namespace libstyle {

class JumpCosts {
 public:
  // `example` outlives it.
  explicit JumpCosts(const Example& example);

  // The mean squared difference, px^2, between what surrounds the beginning of state `from`, or its
  // end, and what surrounds the beginning of each state. `costs` has one slot for each state. Costs
  // least when asked for in rising order.
  void from_start_of(std::size_t from, std::span<double> costs);
  void from_end_of(std::size_t from, std::span<double> costs);

 private:
  // The samples [begin, end) of a window exist.
  struct Taps {
    std::size_t begin = 0, end = 0;
  };

  void weigh_features();
  void lay_grid();
  void sample_line(const ExampleLine& line, std::size_t first_place, std::size_t states);
  void append_components(std::vector<double>& components, const Lane& lane, double length) const;

  // Where a place of the grid is in the tables.
  std::size_t at(std::size_t place) const { return (place % fine_) * slots_ + place / fine_; }
  Taps taps_at(std::size_t place) const;
  double weight_of(Taps taps) const;
  const std::vector<double>& differences_from(std::size_t place);
  void compare(std::size_t place, std::span<double> costs);

  const Example& example_;
  std::vector<double> feature_weights_;  // px for a unit of each feature
  std::size_t components_;

  // The grid: `fine_` places a step, in front of and behind each line as many as a window reaches.
  std::size_t fine_ = 1;
  int reach_ = 0;                    // places
  std::vector<double> tap_weights_;  // of -reach .. reach
  std::vector<double> weight_sums_;  // of the taps before each
  std::size_t slots_ = 0;            // steps of the grid
  std::vector<std::size_t> starts_;  // the slot of each state
  std::vector<Taps> taps_;           // of each state
  std::vector<double> samples_;      // [component][place % fine][slot]
  std::vector<double> present_;      // [place % fine][slot]: 1 where there is a sample, else 0

  // The last rows of the table: squared differences of samples from the one at `place`, by slot.
  struct Row {
    std::size_t place = std::numeric_limits<std::size_t>::max();
    std::vector<double> differences;
  };
  std::vector<Row> rows_;
  std::vector<double> sums_;  // by slot
};

}  // namespace libstyle
