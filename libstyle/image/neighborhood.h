// SPDX-License-Identifier: Apache-2.0
// Neighbourhoods over two levels: the windows at this level and at the coarser one.
#pragma once

#include <cstddef>
#include <limits>

#include "libstyle/image/feature_plane.h"
#include "libstyle/image/window.h"

namespace libstyle::image {

// What counts in a neighbourhood. At the coarsest level `coarse` has no weights.
struct Neighborhood {
  WindowWeights fine;
  WindowWeights coarse;
};

// The two windows of one pixel, by their first samples. `coarse` is null at the coarsest level.
struct Windows {
  const float* fine = nullptr;
  const float* coarse = nullptr;
};

// Floats from one row of a window to the next.
struct RowSteps {
  std::ptrdiff_t fine = 0;
  std::ptrdiff_t coarse = 0;
};

// |F(a) - F(b)|^2. The result may be too small, but not below `limit`, where it is above that.
inline float neighborhood_distance(const Neighborhood& what, const Windows& a,
                                   const RowSteps& a_rows, const Windows& b, const RowSteps& b_rows,
                                   float limit = std::numeric_limits<float>::max()) {
  const float fine = window_distance(what.fine, a.fine, a_rows.fine, b.fine, b_rows.fine);
  if (!a.coarse || fine >= limit) return fine;
  return fine + window_distance(what.coarse, a.coarse, a_rows.coarse, b.coarse, b_rows.coarse);
}

}  // namespace libstyle::image
