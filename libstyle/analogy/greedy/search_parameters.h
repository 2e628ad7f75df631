// SPDX-License-Identifier: Apache-2.0
// Every symbol of the paper's search, with its unit, range and default.
//
// Source: Hertzmann, Oliver, Curless and Seitz, "Curve Analogies", Eurographics Workshop on
// Rendering 2002, section 3.6. Two sets of values are worth starting from: the defaults, which are
// repaired so that detail comes back at the fine levels, and paper_parameters(), which are as
// printed but for misprints.
//
// Lengths. The search works in internal units in which the finest spacing D is 0.5, as in the
// paper, so that weights and spacings mean the same for every example. What is "in spacings" is a
// multiple of the spacing D of the level at hand.
#pragma once

#include <cstdint>
#include <optional>

#include "libstyle/base/random.h"

namespace libstyle {

inline constexpr double kFinestSpacing = 0.5;  // internal units

struct SearchParameters {
  // Tells results apart that are otherwise made the same way.
  std::uint64_t seed = 1;

  // Whether pieces of the example may be turned (R'); otherwise they keep their direction.
  bool rotate = true;

  // ---- The pyramid ---------------------------------------------------------------------------

  // D of the finest level, in px of the drawing. > 0. Unset: the length of A' / samples.
  std::optional<double> finest_spacing;
  int samples = 1200;  // 100 .. 20000

  // L + 1, the number of levels, 1 .. 64. Unset: as many as bring the length of the coarsest A' to
  // about coarsest_samples spacings, blurred as it is there. 60 draws a little better than 80 and
  // 120 on waves, zigzags and rivers, as well on coasts; loops do not like fewer levels.
  std::optional<int> levels;
  int coarsest_samples = 60;  // 20 .. 10000

  // Of the spacings of neighbouring levels. 1 < level_ratio <= 4.
  double level_ratio = 1.2;

  // ---- Neighborhoods -------------------------------------------------------------------------

  // n of the weights w_k = C(n-1, k) / C(n-1, (n-1)/2): odd, 3 .. 401. The standard deviation is
  // sqrt(n - 1) / 2 samples.
  int binomial_order = 101;
  // How many of the n samples are kept, around the middle: odd, 3 .. binomial_order. 33 of 101
  // leave out 1e-3 of the weight.
  int neighborhood_samples = 33;
  // Distance between samples along the curve, in spacings. > 0.
  double sample_spacing = 0.5;
  // Of the weight of a neighborhood's samples, how much a candidate must have as well: 0 < .. <= 1.
  // Neighborhoods at the end of a curve have few samples and would win for want of a comparison.
  double least_overlap = 1;

  // ---- The cost ------------------------------------------------------------------------------

  double tangent_weight = 100;  // w_delta, >= 0, squared internal units
  double shape_weight = 0;      // w_B, >= 0; 0: only place and direction of B count
  double coarse_weight = 2;     // w_B'(l-1), > 0: of the level above
  double offset_weight = 3.8;   // w_OFFSET of analogies, > 0: what else says where B' begins
  double synthesis_offset_weight = 19;  // w_OFFSET of synthesis, >= 0
  double position_weight = 1;           // w_new, > 0

  // kappa: vertices that do not continue a copied piece cost 1 + kappa / D times as much. >= 0.
  double coherence = 2;
  // D in that factor: of the finest level at all levels (true), or of the level at hand, which
  // weakens coherence where pieces are laid out.
  bool coherence_of_finest = true;
  // Continue the piece before or the piece after (true), or only the one before.
  bool coherence_both_ways = true;

  // ---- The search ----------------------------------------------------------------------------

  double step = 2;  // Delta t of the first pass, in spacings, > 0

  // Candidates within best * (1 + epsilon) + floor are equally likely. >= 0. The floor is a
  // quantile (0 .. 1) of how well places of A' are matched by the best other place. Both hold at
  // the `random_levels` coarsest levels; at finer ones there is no floor, and the epsilon is
  // another.
  double epsilon = 0.1;
  double floor_quantile = 0.05;
  int random_levels = 3;  // 0 .. 64
  double fine_epsilon = 0;

  int coarsest_passes = 2;       // refinements after the first pass, 0 .. 100
  int passes = 3;                // refinements at every other level, 1 .. 100
  bool alternate_passes = true;  // every other refinement goes backwards

  // New levels begin as the level above with the detail of the copied pieces added (true), or as
  // the level above, resampled.
  bool detail_transfer = true;

  // A curve that grows beyond this many times its expected length is given up, with an error.
  // > 1.
  double longest_growth = 12;
};

// As printed, but for misprints: D of 0.5 px, 8 levels, 101 samples D/4 apart, kappa = 1/2, one
// refinement a level, and a floor at the coarsest level only, where the choice is random.
SearchParameters paper_parameters();

// Throws Error naming the first member that is out of range, and the range.
void validate(const SearchParameters& parameters);

// The random numbers of one pass: number i of it decides vertex i, number 0 of pass 0 the
// beginning. `place` tells the curves of a drawing apart, levels count from the coarsest, and pass
// 0 is the one that grows a curve.
inline RandomStream pass_random(std::uint64_t seed, std::uint64_t place, int level, int pass) {
  return {seed, (place << 16) | (static_cast<std::uint64_t>(level) << 8) |
                    static_cast<std::uint64_t>(pass)};
}

}  // namespace libstyle
