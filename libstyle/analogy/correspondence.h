// SPDX-License-Identifier: Apache-2.0
// Which place of the unfiltered example belongs to which place of the filtered one.
#pragma once

#include <vector>

#include "libstyle/geometry/polyline.h"

namespace libstyle {

// For each vertex of `filtered`, the length along `unfiltered` that it belongs to: rising from 0 to
// the whole length. Found by dynamic time warping (Sakoe and Chiba, IEEE ASSP 26(1), 1978): the
// monotone pairing of places with the least sum of squared distances, after the curves have been
// moved to where they lie closest. Matching by equal shares of arc length instead lets features
// drift off the line where one part of an example is busier than another. Both are open and have a
// length.
std::vector<double> corresponding_lengths(const Polyline& filtered, const Polyline& unfiltered);

}  // namespace libstyle
