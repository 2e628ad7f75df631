// SPDX-License-Identifier: Apache-2.0
// A walk that changes here and there: the frames of a line that lives.
//
// The steps are cut into pieces, at other places each time. Some of the pieces, chosen at random,
// are drawn anew given the states before and after them, all else stays: block Gibbs sampling. A
// walk with the probability that the chain gives to it stays one, however often that is done, so
// that no frame is less like the example than the first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libstyle/analogy/chain.h"
#include "libstyle/base/random.h"

namespace libstyle {

struct WalkChange {
  double share = 0;           // of the pieces that are drawn anew, 0 .. 1
  std::size_t piece = 1;      // steps; > 0
  bool closed = false;        // the last state leads back to the first
  ChainVariety variety = {};  // as for the walk; a run that goes on beyond its piece ends there too
};

// The next frame of a walk of a task (its origin and next do not count). The chain's own
// distribution is kept exactly without variety. `random` is asked for numbers at first_place ..
// first_place + 2^25.
std::vector<ChainState> changed_walk(const ChainModel& model, const ChainTask& task,
                                     std::span<const ChainState> walk, const WalkChange& change,
                                     const RandomStream& random, std::uint64_t first_place);

}  // namespace libstyle
