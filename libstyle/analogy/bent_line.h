// SPDX-License-Identifier: Apache-2.0
// A line bent so that places of it come to lie elsewhere.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "libstyle/geometry/polyline.h"

namespace libstyle {

// At `length` along the line, it is to be moved by `offset`.
struct Bend {
  double length = 0;
  Vector offset;
};

// The style is drawn along the bent line, so it is not sheared as it would be if it were drawn
// first and moved then. The line is moved by Gaussian bumps (warp.h) as wide as the style needs, or
// wide enough that the line leaves its direction by no more than half a px a px: so that it does
// not fold.
class BentLine {
 public:
  // As it is.
  explicit BentLine(const Polyline& line);
  // `bends` by rising length; a bend of zero keeps its place. `feature` is the size of what is to
  // be drawn along the line, px.
  BentLine(const Polyline& line, std::span<const Bend> bends, double feature);

  const Polyline& line() const { return line_; }
  // Lengths along the line as it was given and as it is bent. The places of bends and the ends
  // correspond exactly. Round a closed line a bent length may go on beyond the seam.
  double bent_length(double plain) const;
  double plain_length(double bent) const;

 private:
  Polyline line_;
  // At each vertex; once more at the end of a closed line. Empty: the line is not bent.
  std::vector<double> plain_, bent_;
};

}  // namespace libstyle
