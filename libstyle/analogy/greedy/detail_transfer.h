// SPDX-License-Identifier: Apache-2.0
// Begins a level with the detail that the level above could not show.
//
// The paper begins B'_l as B'_(l-1), resampled. That curve is as smooth as the level above, its
// neighborhoods find the smooth places of A'_l, and detail never comes back: after synthesis only a
// third to two thirds of the length is there. But it is known where every vertex was copied from:
//     B'_l(t) = B'_(l-1)(t) + R (A'_l(s) - A'_(l-1)(s)),
// and between two vertices that continue one copied piece s runs along that piece. Between two that
// do not, the pieces before and after run on and fade into each other. New vertices are spaced
// evenly by the length that this gives to the curve, so that length comes back as well.
#pragma once

#include <span>

#include "libstyle/analogy/greedy/level_example.h"
#include "libstyle/analogy/greedy/level_search.h"

namespace libstyle {

// `drawn` is B'_(l-1), of at least two vertices that all have sources in `coarse`, the example at
// that level; `fine` is the example at the next. The result has a vertex at each of the parameters
// `kept`, and its sources are places of `fine`.
DrawnLevel transfer_detail(const LevelExample& coarse, const LevelExample& fine,
                           const DrawnLevel& drawn, std::span<const double> kept);

}  // namespace libstyle
