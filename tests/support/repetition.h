// SPDX-License-Identifier: Apache-2.0
// Whether a walk over an example goes round in circles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/analogy/runs.h"

namespace libstyle {

// The largest share of the steps that are the same so many steps later, for any number of steps: 1
// for a walk that goes round and round, and near 0 for one that does not. O(n^2).
inline double repetition(std::span<const ChainRun> runs) {
  std::vector<std::size_t> states;
  for (const ChainRun& run : runs) {
    for (std::size_t k = 0; k < run.steps; ++k) states.push_back(run.origin + k);
  }
  double most = 0;
  for (std::size_t lag = 8; lag < states.size() / 2; ++lag) {
    double same = 0;
    for (std::size_t i = 0; i + lag < states.size(); ++i) same += states[i] == states[i + lag];
    most = std::max(most, same / static_cast<double>(states.size() - lag));
  }
  return most;
}

}  // namespace libstyle
