// SPDX-License-Identifier: Apache-2.0
// The chain over the states of an example, for runs of `mean_run` feature sizes on average.
//
// Jumps go to the best phase of every other place, at least two feature sizes away. A jump is as
// likely as exp(-cost / tolerance), where the tolerance, the cost of what still looks alike, is the
// 10 % quantile of the cost of the nearest other place: it calibrates itself. From a place without
// its like there are no jumps. Jumps into the last two feature sizes of a line would lead nowhere
// and do not happen, unless `ends_allowed`.
#pragma once

#include "libstyle/analogy/chain.h"
#include "libstyle/analogy/example.h"

namespace libstyle {

struct JumpModel {
  ChainModel chain;
  double tolerance = 0;  // px^2
};

JumpModel make_jump_model(const Example& example, double mean_run, bool ends_allowed);

}  // namespace libstyle
