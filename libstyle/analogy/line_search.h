// SPDX-License-Identifier: Apache-2.0
// Draws lines by the search of the paper (greedy/greedy_search.h) instead of by a walk over states.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libstyle/analogy/assembly.h"
#include "libstyle/analogy/example.h"
#include "libstyle/analogy/greedy/greedy_search.h"
#include "libstyle/analogy/parameters.h"

namespace libstyle {

class LineSearch {
 public:
  // `example` outlives the search.
  LineSearch(const Example& example, const CurveAnalogyParameters& parameters);

  struct Result {
    DrawnLine line;
    std::vector<ChainRun> runs;  // in the steps of the example, on the example and on the line
  };

  // `scale` is the size of the style on this line. At the lengths `held`, rising, the line keeps
  // its place exactly: hard constraints. `place` is below 2^48. `variant` is added to the seed.
  Result draw(const Polyline& line, double scale, std::span<const double> held, std::uint64_t place,
              std::uint64_t variant) const;

 private:
  std::vector<std::vector<double>> copied_features(const SearchedCurve& drawn, double scale) const;
  std::vector<ChainRun> find_runs(const SearchedCurve& drawn) const;
  ChainState state_of(const SearchedCurve::Source& source) const;

  const Example& example_;
  std::vector<std::size_t> first_states_;  // of each line of the example
  GreedySearch search_;
};

}  // namespace libstyle
