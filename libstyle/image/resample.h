// SPDX-License-Identifier: Apache-2.0
// The step from one level of a Gaussian pyramid to the next, coarser one.
#pragma once

#include "libstyle/image/image.h"

namespace libstyle::image {

// Blurred with the binomial kernel (1 4 6 4 1) / 16 along both axes, then every second pixel of
// every second row, from the first on. Beyond the edge lies the nearest pixel. The result has
// (width + 1) / 2 by (height + 1) / 2 pixels, at least 1 by 1: pixel (x, y) belongs to
// (x / 2, y / 2) of it.
Image halved(const Image& image, int threads);

}  // namespace libstyle::image
