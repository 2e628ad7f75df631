// SPDX-License-Identifier: Apache-2.0
// The pseudo-code of the paper, written down as it is printed: the yardstick of truth and of speed.
//
// Source: Hertzmann, Oliver, Curless and Seitz, "Curve Analogies", Eurographics Workshop on
// Rendering 2002, the listings of sections 3.1, 3.3, 3.4 and 3.5. One thread, every neighborhood
// sampled anew for every candidate, every alignment computed from the points, every candidate
// scored: no screening and no tables. Nothing of libstyle/analogy is used but its parameters.
//
// Corrected, because the listings cannot run otherwise:
//  - candidates are d_j <= d_min (1 + eps) + floor (printed the other way round: empty);
//  - floor: the quantile of what each place of A' costs at its best other place; copying makes
//    d_min 0, and a share of 0 leaves no choice;
//  - jumps do not lead into the last half neighborhood of A' while B' grows;
//  - windows centre on t_new, at the same arc distance from s_j and t_new on both sides; samples
//    that do not exist on either side drop out, the rest counts as much as the whole, and a
//    candidate must have 60 % of the weight;
//  - spacings of levels are .5 * 1.2^(L - l); constraints gain a variance of L - l;
//  - w_k = C(n-1, k) / C(n-1, (n-1)/2);
//  - d_j holds the match of the shapes, not only the constraints; d_min comes after the loop over
//  j;
//    t_i come from B; hard constraints still search for S(i); Eq. 6 sums over i;
//  - steps are coherent from half to one and a half times the length on B', and S(i) is s_j;
//  - the offset solves p = (sum w q + w_OFF m r) / (sum w + w_OFF m^2) with r = m q, and the centre
//    of mass of A' is that of the samples B' has;
//  - with w_B = 0 the shape of B still counts for R', with weight 1;
//  - the first curve of synthesis is half a neighborhood long, not three points.
// Curves are in internal units: D = .5 at the finest level.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/analogy/curve_constraint.h"
#include "libstyle/analogy/greedy/search_parameters.h"
#include "libstyle/base/random.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle::literal {

// B' and S: the vertex of A' that each of its control points came from.
struct CopiedCurve {
  SampledCurve curve;
  std::vector<std::size_t> sources;
};

// A curve A of the example and the B it corresponds to, with its weight in the cost.
struct SourcePair {
  SampledCurve example;
  SampledCurve target;
  double weight = 1;
};

// {A ...} : A' :: {B ...} : B' at one level.
struct Level {
  SampledCurve filtered;  // A'
  std::vector<SourcePair>
      sources;               // A and B, A'_(l-1) and B'_(l-1); none in single-scale synthesis
  double spacing = 0.5;      // D
  double offset_weight = 0;  // w_OFFSET
  double epsilon = 0;
  bool has_floor = false;
  std::vector<CurveConstraint> constraints;  // with the weights of this level
};

// function SYNTHESIZECURVE(A'). Random choices: place 0 for the start, place i for vertex i.
CopiedCurve synthesize_curve(const Level& level, double length, const SearchParameters& parameters,
                             const RandomStream& random);

// function SYNTHESIZEANALOGY(A, A', B, constraints)
CopiedCurve synthesize_analogy(const Level& level, const SearchParameters& parameters,
                               const RandomStream& random);

// function REFINEANALOGY(A, A', B, ^B'). `initial` may come without sources.
CopiedCurve refine_analogy(const Level& level, CopiedCurve initial,
                           const SearchParameters& parameters, const RandomStream& random);

// function SYNTHESIZECURVEMULTIRES(A')
CopiedCurve synthesize_curve_multires(const SampledCurve& filtered, double length,
                                      const SearchParameters& parameters);

// function SYNTHESIZEANALOGYMULTIRES(A, A', B)
CopiedCurve synthesize_analogy_multires(const SampledCurve& unfiltered,
                                        const SampledCurve& filtered, const SampledCurve& target,
                                        std::span<const CurveConstraint> constraints,
                                        const SearchParameters& parameters);

// E(B') of Eq. 6: the sum over the control points of the least cost over all places of A', without
// the coherence term.
double curve_cost(const Level& level, const SampledCurve& drawn,
                  const SearchParameters& parameters);

}  // namespace libstyle::literal
