// SPDX-License-Identifier: Apache-2.0
// Gaussian blur of a curve along its arc length.
//
// The curve is a function P(s) of arc length, linear between vertices; its blur is
//   (G P)(s) = integral of P(s + u) exp(-u^2 / (2 sigma^2)) / (sqrt(2 pi) sigma) du.
// Beyond the ends of an open curve P is reflected through the end point, P(-s) = 2 P(0) - P(s), so
// that end points stay where they are and straight lines stay straight. Closed curves are periodic.
//
// Both ways of computing it answer to the integral, not to the vertices, so uneven spacing is as
// good as even:
//  1. exactly, when few vertices lie within reach of sigma. With unit tangents, P'' is a spike J_k
//     (the change of tangent) at each vertex, hence G P = P + sum_k J_k g(s - s_k) with
//     g(u) = sigma phi(u / sigma) - |u| Phi(-|u| / sigma), phi and Phi the normal density and
//     distribution: short sums, for g vanishes beyond a few sigma.
//  2. on a grid of sigma / 8 otherwise: exact means of P under the cubic B-spline of each node
//     (which keeps detail finer than the grid from turning up as something else), a finite kernel
//     of variance sigma^2 - step^2 / 3 (the spline has the rest), and six-point interpolation.
//     Within 2e-6 of the exact value relative to the size of the curve, however rough it is.
//
// Cost: O(n + length / sigma) at most.
#pragma once

#include "libstyle/geometry/polyline.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {

// Every vertex moved to its place on the blurred curve: as many vertices, in the same order, so
// values at vertices stay valid. sigma >= 0, in the curve's own units. Throws Error
// when the length is not finite.
Polyline gaussian_blur(const Polyline& polyline, double sigma);

}  // namespace libstyle
