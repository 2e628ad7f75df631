// SPDX-License-Identifier: Apache-2.0
// How far a line gives way to soft constraints.
//
// Where a line would go by itself is the mean of a Gaussian: it may as well go elsewhere, the less
// likely the farther, and neighbouring places go together. A constraint <t, q, w> is a measurement
// of the line at t that says q with variance 1 / w (Hertzmann et al. 2002, section 3.4, sees it
// so). What both say together is again a Gaussian; its mean is where the line is to go. A single
// constraint, r px away, brings the line d^2 / (d^2 + 1 / w) r nearer with the deviation d of the
// line: the nearer the heavier, and onto it where w is infinite.
//
// Neighbouring places have the correlation exp(-distance / reach). It makes the line a Markov chain
// from constraint to constraint: the mean lies between what its neighbours want and never swings,
// however near to each other they are, as it would with a smoother correlation.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "libstyle/geometry/point.h"

namespace libstyle {

struct Pull {
  double length = 0;             // where it acts, along the line
  Vector offset;                 // from where the line would go by itself to where it is wanted
  std::optional<double> weight;  // > 0, 1/px^2; unset: hard
};

// The prior: how far a line strays, px, and over what length it does so together; > 0.
struct Stiffness {
  double deviation = 0;
  double reach = 0;
};

// For each pull the offset that the line gives way by; all of it where the pull is hard. `pulls`
// by rising length, no two the same. `period`: the length of a closed line, whose ends are
// neighbours. Cost: O(pulls).
std::vector<Vector> yielding_offsets(std::span<const Pull> pulls, const Stiffness& stiffness,
                                     std::optional<double> period = {});

}  // namespace libstyle
