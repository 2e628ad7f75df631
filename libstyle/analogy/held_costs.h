// SPDX-License-Identifier: Apache-2.0
// Lets a walk come near the places that its line has to pass.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/analogy/example.h"
#include "libstyle/geometry/point.h"

namespace libstyle {

// How ill each state suits a place that is held: the squared distance of what it draws there from
// where the drawn line is to pass, over twice a squared spread. What is left over is bent into
// place by the warp of the assembly.
class HeldCosts {
 public:
  // A place on a line, and where the drawn line is to pass it: an offset in its frame and in the
  // size of the example.
  struct Place {
    double x = 0;  // style coordinate
    Vector offset;
  };

  // `example` need not outlive it.
  explicit HeldCosts(const Example& example);

  // Adds the costs of a step of a line of `steps` steps that is held at these places. Returns
  // whether there are any; see StepCosts.
  bool add(std::size_t step, std::size_t steps, std::span<const Place> held,
           std::span<double> costs) const;

 private:
  double cost(std::span<const Vector> strokes, Vector wanted) const;

  double spread_;                                   // px
  std::vector<std::vector<Vector>> starts_, ends_;  // for each state, the offsets of its strokes
};

}  // namespace libstyle
