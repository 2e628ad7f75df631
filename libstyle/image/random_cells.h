// SPDX-License-Identifier: Apache-2.0
// What texture synthesis begins with: pieces of the examples side by side.
#pragma once

#include <cstdint>

#include "libstyle/image/level.h"

namespace libstyle::image {

// Without a guide the first pixels decide what follows: copied on from one place, the examples
// would come out again whole. So the coarsest level starts as cells of this many pixels a side,
// each copied from a place of its own, which later passes join.
void fill_with_random_cells(Level& level, int side, std::uint64_t seed, SourceIndices& sources);

}  // namespace libstyle::image
