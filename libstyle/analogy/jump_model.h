// SPDX-License-Identifier: Apache-2.0
// The chain over the states of an example: how a walk goes on, and where it jumps.
//
// Jumps go to the best phase of every other place, at least two feature sizes away. A jump is as
// likely as exp(-cost / tolerance), where the tolerance, the cost of what still looks alike, is the
// 10 % quantile of the cost of the nearest other place: it calibrates itself. From a place without
// its like there are no jumps. Jumps into the last two feature sizes of a line would lead nowhere
// and do not happen, unless that is allowed.
#pragma once

#include "libstyle/analogy/chain.h"
#include "libstyle/analogy/example.h"

namespace libstyle {

struct JumpParameters {
  double mean_run = 8;        // feature sizes; > 0
  bool ends_allowed = false;  // jumps into the end of a line
  // Times the tolerance that the example gives; > 0. More lets a walk get about more freely, and
  // shows more.
  double freedom = 1;
};

struct JumpModel {
  ChainModel chain;
  double tolerance = 0;  // px^2
};

JumpModel make_jump_model(const Example& example, const JumpParameters& parameters);

}  // namespace libstyle
