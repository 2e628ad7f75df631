// SPDX-License-Identifier: Apache-2.0
// The neighborhoods of the paper's section 3.1, and how two of them are aligned and compared.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/point.h"

namespace libstyle::literal {

// Samples k = 0 .. n-1 around a place, evenly along the curve; those beyond its ends do not exist.
using Neighborhood = std::vector<std::optional<Point>>;

// `center` is a length along the curve; beyond its end while the curve grows.
Neighborhood sample_neighborhood(const ArcLength& curve, double center, double spacing,
                                 std::size_t count);

// w_k: binomial coefficients of order - 1, the middle one 1; the middle `count` of them.
std::vector<double> binomial_weights(int order, int count);

// What two neighborhoods have in common.
struct Comparison {
  double overlap = 0;          // weight of the samples of b that a has too, as a share of b's
  double scale = 0;            // 1 / overlap: makes the rest count as much as the whole
  Point mean_a, mean_b;        // of the common samples
  double weight = 0;           // of the common samples
  std::complex<double> twist;  // sum w conj(a) b over centred positions and w_delta tangents
};

Comparison compare(const Neighborhood& a, const Neighborhood& b, const std::vector<double>& weights,
                   double tangent_weight);

// sum_k w_k (|R a_k + t - b_k|^2 + w_delta |R da_k - db_k|^2) over the common samples, where t
// brings the means together and R turns by `rotation`.
double shape_distance(const Neighborhood& a, const Neighborhood& b, const Comparison& comparison,
                      std::complex<double> rotation, const std::vector<double>& weights,
                      double tangent_weight);

Vector turn(std::complex<double> rotation, Vector v);

}  // namespace libstyle::literal
