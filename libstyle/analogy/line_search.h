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
#include "libstyle/analogy/line_constraints.h"
#include "libstyle/analogy/parameters.h"
#include "libstyle/analogy/style_summary.h"

namespace libstyle {

// The symbols of the search; what it has in common with the chain is set in one place.
SearchParameters search_parameters(const CurveAnalogyParameters& parameters);

// What was copied, as pieces of the example on a line of as many steps.
std::vector<ChainRun> find_runs(const Example& example, const SearchedCurve& drawn);

// The features of the places that the vertices were copied from, with the style at a scale.
std::vector<std::vector<double>> copied_features(const Example& example, const SearchedCurve& drawn,
                                                 double scale);

// A longer curve would take minutes: half a millisecond for each of its vertices, and more as the
// paper has it.
double longest_curve(const GreedySearch& search);

StyleSummary::Search summarize(const GreedySearch& search, const SearchParameters& parameters);

class LineSearch {
 public:
  // `example` outlives the search.
  LineSearch(const Example& example, const CurveAnalogyParameters& parameters);

  struct Result {
    DrawnLine line;
    std::vector<ChainRun> runs;  // in the steps of the example, on the example and on the line
  };

  // `scale` is the size of the style on this line. `constraints` by rising length, no two at the
  // same place. `place` is below 2^48. `variant` is added to the seed.
  Result draw(const Polyline& line, double scale, std::span<const LineConstraint> constraints,
              std::uint64_t place, std::uint64_t variant) const;

  double longest_line() const { return longest_curve(search_); }
  StyleSummary::Search summary() const { return summarize(search_, parameters_); }

 private:
  const Example& example_;
  SearchParameters parameters_;
  GreedySearch search_;
};

}  // namespace libstyle
