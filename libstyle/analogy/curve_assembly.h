// SPDX-License-Identifier: Apache-2.0
// The lines of a curve, drawn one by one, put together again.
#pragma once

#include <cstddef>
#include <vector>

#include "libstyle/analogy/assembly.h"
#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/analogy/plain_lines.h"

namespace libstyle {

// One line of a curve, drawn.
struct DrawnPart {
  DrawnLine line;
  std::vector<DrawnLine> strokes;  // of a style that draws lines as strokes
  std::vector<ChainRun> runs;
  double scaled_length = 0;  // the length, times the mean of the local scale
  std::vector<ChainState> walk = {};
};

class CurveAssembly {
 public:
  // `features`: how many the example has.
  CurveAssembly(const Polyline& curve, std::size_t features);

  // The next line, in order; `last`: no other follows it.
  void append(DrawnPart drawn, const PlainLine& line, bool last);

  // The curve, once there is a line.
  StyledCurve take();

 private:
  void append_points(const DrawnLine& line, double length_before, bool last);

  bool closed_;
  StyledCurve result_;
  double length_ = 0, scaled_length_ = 0;
};

}  // namespace libstyle
