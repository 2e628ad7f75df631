// SPDX-License-Identifier: Apache-2.0
// The pseudo-code of the paper, line by line: what the library is held against.
//
// Slow and simple: doubles, vectors, every place of the example for every pixel. It takes finished
// pyramids, so that only the search and the decisions are compared; one example, guide and filtered
// pictures of any number of channels.
#pragma once

#include <vector>

#include "libstyle/image/image.h"
#include "libstyle/image/image_analogy.h"

namespace libstyle::test {

struct LiteralLevel {
  Image unfiltered;  // A_l
  Image filtered;    // A'_l
  Image target;      // B_l
};

// `levels` from the coarsest to the finest; windows of 5x5, and 3x3 at the coarser level. Returns
// the map of sources of the finest level.
std::vector<SourcePixel> literal_image_analogy(const std::vector<LiteralLevel>& levels,
                                               double kappa);

}  // namespace libstyle::test
