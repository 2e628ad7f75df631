// SPDX-License-Identifier: Apache-2.0
// Aims random walks over an example, whose pieces keep their direction, at given places.
//
// A stretch of n steps is to move by D in all. Walks that do so by chance look, by the theory of
// large deviations, like walks of the chain with each step from state j weighted by exp(a . m_j),
// where m_j is the move that state j draws: the pieces that lead there come a little more often,
// and nothing is bent. The vector a, one for each stretch, is found by trying: where a walk missed
// by e, a grows by e / (n v) times a share below 1, where v is the variance of moves a step, so
// that walks on average get where they should.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/analogy/example.h"
#include "libstyle/geometry/point.h"

namespace libstyle {

class WalkAim {
 public:
  struct Stretch {
    double begin = 0, end = 0;  // steps, begin < end
    Vector move;                // that is wanted
  };

  // Stretches follow one another. `example` outlives the aim.
  WalkAim(const Example& example, std::span<const Stretch> stretches);

  // See StepCosts.
  bool add(std::size_t step, std::span<double> costs) const;

  // Learns from a walk that moved so on the stretches.
  void correct(std::span<const Vector> moves);

 private:
  double step_ = 0;            // px
  double variance_ = 0;        // of moves, a step, px^2
  std::vector<Vector> drawn_;  // by each state
  std::vector<Stretch> stretches_;
  std::vector<Vector> tilts_;  // a, 1/px
};

}  // namespace libstyle
