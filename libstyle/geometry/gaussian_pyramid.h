// SPDX-License-Identifier: Apache-2.0
// A curve at several scales, each blurred and sampled more coarsely than the next.
//
// Source: the curve pyramid of Hertzmann, Oliver, Curless and Seitz, "Curve analogies", EGRW 2002,
// section 3. There the spacing of level l of L is printed as D = .5 * 1.2^(l - L), which makes
// coarse levels finer than fine ones; here it is finest_spacing * ratio^(L - l). The blur, which is
// not given, is sigma_l^2 = D_l^2 - D_L^2, taken from the finest curve each time, so that the
// finest level is not blurred.
#pragma once

#include <span>
#include <vector>

#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {

struct GaussianPyramidParams {
  double finest_spacing = 0.5;  // > 0, in the curve's units
  double ratio = 1.2;           // > 1, of the spacings of neighbouring levels
  int levels = 8;               // 1 .. 64
};

struct GaussianPyramidLevel {
  double spacing = 0;
  double sigma = 0;
  SampledCurve curve;
};

// The levels, coarsest first. Vertices keep their t, and every level has a vertex at each of the
// parameters `kept` exactly (see resample). Open curves keep their end points on all levels.
// Throws Error when a parameter is out of range.
std::vector<GaussianPyramidLevel> gaussian_pyramid(const SampledCurve& curve,
                                                   const GaussianPyramidParams& params,
                                                   std::span<const double> kept = {});

}  // namespace libstyle
