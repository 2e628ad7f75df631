// SPDX-License-Identifier: Apache-2.0
// How strongly a picture changes, in four directions: third derivatives of a Gaussian.
//
// Source: the paper, section 3.3, which takes third-derivative steerable filters of four kernels
// for line art; Freeman and Adelson, "The design and use of steerable filters", 1991: the third
// derivative along any direction is a sum of those along four. They say which way an edge runs and
// on which side it is dark, over more than one pixel, and are used for matching in A and B only.
//
// The Gaussian has a deviation of 1.2 px; each kernel is 9 by 9 px, sums to zero, and its squares
// sum to 1, so that noise gives as much in each direction. At the levels of a pyramid the same
// kernels see larger and larger edges.
#pragma once

#include "libstyle/image/image.h"

namespace libstyle::image {

// Four channels: the responses along 0, 45, 90 and 135 degrees, counted from the x axis downwards.
// `luminance` has one channel; beyond the edge lies the nearest pixel.
Image oriented_responses(const Image& luminance, int threads);

}  // namespace libstyle::image
