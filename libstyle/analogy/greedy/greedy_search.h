// SPDX-License-Identifier: Apache-2.0
// Draws a curve B in the style of an example A : A', or a new curve like A', by searching the
// example for every vertex, from a coarse curve to a fine one.
//
// Source: Hertzmann, Oliver, Curless and Seitz, "Curve Analogies", Eurographics Workshop on
// Rendering 2002. The whole method of the paper:
//  1. Pyramids of A, A' and B: blurred and sampled ever more coarsely.   sections 3.4, 3.5
//                                                                   geometry/gaussian_pyramid.h
//  2. The coarsest B' grows vertex by vertex.                           3.1, 3.3  level_search.h
//  3. At every finer level B' begins as the level above and is chosen anew, vertex by vertex, from
//     {A_l, A'_(l-1)} : A'_l :: {B_l, B'_(l-1)} : B'_l.                  3.4, 3.5  level_search.h
//  4. Constraints hold at all levels, the softer the coarser.             3.2, 3.4
//                                                                               softened_weight.h
//
// Symbols: A unfiltered, A' filtered, B target, B' drawn, s_j places of the example, S(i) sources,
// L + 1 levels, D spacing; the other letters are with their parameters in search_parameters.h.
//
// Departures, all of them parameters; paper_parameters() undoes them. Followed to the letter,
// detail does not come back at the fine levels, runs are of one to three samples, and corners knot.
//  - a level begins with the detail of the copied pieces added           detail_transfer.h
//  - neighborhoods reach twice as far (sigma 2.5 D), with samples D/2 apart instead of D/4
//  - three passes a level, there and back; coherence with the vertex before or after, as strong at
//    coarse levels as at fine ones
//  - the number of levels comes from the length of the example
//  - randomness at the coarse levels only
// Misprints that are corrected in any case are listed in the source of what they concern.
//
// Guarantees: the same seed gives the same result; moving B moves B'; hard constraints are met
// exactly. Cost: for every vertex of B' and every place of A' a dozen complex products, a few
// hundred for the few that could be the best; with levels and passes about
//   passes * 3.3 * (vertices of B') * (vertices of A') of those, at a ratio of 1.2.
//
//   const GreedySearch search(examples, parameters);
//   for (std::size_t i = 0; i < curves.size(); ++i) drawn[i] = search.draw(curves[i], {}, i);
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/analogy/curve_constraint.h"
#include "libstyle/analogy/greedy/search_parameters.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {

// A : A', of the same parameter t. Without the unfiltered curve it serves for synthesis.
struct SearchExample {
  std::optional<SampledCurve> unfiltered;
  SampledCurve filtered;
};

struct SearchedCurve {
  SampledCurve curve;  // B', with the parameter of B
  // Where each vertex was copied from.
  struct Source {
    std::size_t example = 0;
    double length = 0;       // px along the filtered curve
    double t = 0;            // the parameter there
    bool continues = false;  // the piece that the vertex before was copied from
  };
  std::vector<Source> sources;
};

class GreedySearch {
 public:
  // Either all examples have unfiltered curves or none. Throws Error when a parameter is out of
  // range or an example cannot serve.
  GreedySearch(std::span<const SearchExample> examples, const SearchParameters& parameters);
  ~GreedySearch();
  GreedySearch(GreedySearch&&) noexcept;
  GreedySearch& operator=(GreedySearch&&) noexcept;

  // B' for a target, whose t is that of the constraints. `place` tells the curves of a drawing
  // apart, `variant` is added to the seed. The examples have unfiltered curves. Safe to call from
  // several threads.
  SearchedCurve draw(const SampledCurve& target, std::span<const CurveConstraint> constraints = {},
                     std::uint64_t place = 0, std::uint64_t variant = 0) const;

  // A new curve about `length` px long (> 0), t = 0 .. 1: as much shorter or longer as detail is
  // lost or made from level to level. The examples have no unfiltered curves.
  SearchedCurve synthesize(double length, std::span<const CurveConstraint> constraints = {},
                           std::uint64_t place = 0, std::uint64_t variant = 0) const;

  // What the parameters that were left to the example came out as.
  double finest_spacing() const;  // px
  int levels() const;

 private:
  class Implementation;
  std::unique_ptr<const Implementation> implementation_;
};

}  // namespace libstyle
