// SPDX-License-Identifier: Apache-2.0
// How large the style is along a line, and the line cut into steps of the example.
//
// The style keeps its size on the page where there is room for it. A line that is shorter than a
// few features, or that bends more tightly than the style strays from it, gets the style smaller,
// all of it, lengths and offsets alike: a letter in wiggly lines stays a letter. Left at full size
// it would fold over itself inside the bends, and short sides would be one bump.
//
// The style coordinate x counts steps: dx = length along the line / (step * local scale), rounded
// to a whole number of steps over the line.
#pragma once

#include <cstddef>
#include <vector>

#include "libstyle/analogy/example.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

// How long a line has to be for the style at its own size, in px.
double room_needed(const Example& example);

class StyleGrid {
 public:
  // `line` has a length.
  StyleGrid(const Polyline& line, const Example& example, const CurveAnalogyParameters& parameters);

  std::size_t steps() const { return steps_; }
  double length() const { return lengths_.back(); }
  // The scale of the whole line, before bends; for blurs that belong to the style.
  double line_scale() const { return line_scale_; }
  // The mean of the local scale over the length.
  double mean_scale() const;

  // Outside 0 .. steps() an open line goes on straight in its coordinate; for closed lines bring x
  // into the range first.
  double length_at(double x) const;
  double coordinate_at(double length) const;
  double scale_at(double x) const;

 private:
  void measure_bends(const Polyline& line, const Example& example, double smallest);
  void count_steps(double step);

  std::vector<double> lengths_;      // nodes along the line, rising
  std::vector<double> scales_;       // local scale at the nodes
  std::vector<double> coordinates_;  // x at the nodes
  double line_scale_ = 1;
  std::size_t steps_ = 1;
};

}  // namespace libstyle
