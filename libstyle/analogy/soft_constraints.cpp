// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/soft_constraints.h"

#include <cmath>
#include <cstddef>

namespace libstyle {
namespace {

// The equations (Q + W) v = W r, where Q, the inverse of the matrix of correlations, has three
// diagonals. Hard pulls have the equation v = r.
std::vector<Vector> posterior_mean(std::span<const Pull> pulls, const Stiffness& stiffness) {
  const std::size_t n = pulls.size();
  std::vector<double> before(n), middle(n, 1.0), after(n);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double gap = (pulls[i + 1].length - pulls[i].length) / stiffness.reach;
    const double correlation = std::exp(-gap), left_over = -std::expm1(-2 * gap);
    after[i] = before[i + 1] = -correlation / left_over;
    middle[i] += correlation * correlation / left_over;
    middle[i + 1] += correlation * correlation / left_over;
  }
  std::vector<Vector> right(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (pulls[i].weight) {
      const double weight = *pulls[i].weight * stiffness.deviation * stiffness.deviation;
      middle[i] += weight;
      right[i] = weight * pulls[i].offset;
    } else {
      before[i] = after[i] = 0;
      middle[i] = 1;
      right[i] = pulls[i].offset;
    }
  }
  for (std::size_t i = 1; i < n; ++i) {
    const double share = before[i] / middle[i - 1];
    middle[i] -= share * after[i - 1];
    right[i] -= share * right[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n) right[i] -= after[i] * right[i + 1];
    right[i] = right[i] / middle[i];
  }
  return right;
}

}  // namespace

std::vector<Vector> yielding_offsets(std::span<const Pull> pulls, const Stiffness& stiffness,
                                     std::optional<double> period) {
  if (!period) return posterior_mean(pulls, stiffness);
  std::vector<Pull> thrice;
  for (const double turn : {-*period, 0.0, *period}) {
    for (Pull pull : pulls) {
      pull.length += turn;
      thrice.push_back(pull);
    }
  }
  const std::vector<Vector> all = posterior_mean(thrice, stiffness);
  const auto first = all.begin() + std::ssize(pulls);
  return {first, first + std::ssize(pulls)};
}

}  // namespace libstyle
