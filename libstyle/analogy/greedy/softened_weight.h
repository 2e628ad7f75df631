// SPDX-License-Identifier: Apache-2.0
// The weights of constraints at the coarse levels.
#pragma once

#include <optional>

namespace libstyle {

// The weight at a level that many levels above the finest (section 3.4), in units of w_new: a
// constraint is seen as a Gaussian of variance 1 / w_c, and each level above adds 1 to the
// variance, so that coarse curves, which cannot bend as the finest can, are not torn by it. Unset:
// hard, and only at the finest level. The printed formula has the added term inverted: it drops all
// constraints at the finest.
inline std::optional<double> softened_weight(std::optional<double> weight, int levels_above) {
  if (levels_above == 0) return weight;
  return 1 / ((weight ? 1 / *weight : 0.0) + levels_above);
}

}  // namespace libstyle
