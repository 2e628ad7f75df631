// SPDX-License-Identifier: Apache-2.0
// Puts copied pieces together: a curve with given steps that stays near given places.
//
// Source: Perez, Gangnet and Blake, "Poisson image editing", SIGGRAPH 2003, in one dimension and
// screened. The points p minimise
//
//     sum_i |p_{i+1} - p_i - step_i|^2 / h_i  +  sum_i m_i |p_i - anchor_i|^2 / reach^2
//
// where h_i is the length of interval i and m_i the length around point i: where pieces disagree,
// the disagreement is spread over about `reach` to both sides, and shapes in between stay as they
// are. The matrix is tridiagonal, or cyclic tridiagonal on a closed curve: O(n), Thomas algorithm
// and Sherman-Morrison formula.
#pragma once

#include <span>
#include <vector>

#include "libstyle/geometry/point.h"

namespace libstyle {

// One interval between neighbours; on a closed curve the last leads back to the first point.
// `lengths` (> 0) and `steps` have one entry for each interval: one less than `anchors` if open, as
// many if closed. reach > 0. A closed curve has at least 3 points.
std::vector<Point> stitch(std::span<const Point> anchors, std::span<const Vector> steps,
                          std::span<const double> lengths, double reach, bool closed);

}  // namespace libstyle
