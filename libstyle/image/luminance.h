// SPDX-License-Identifier: Apache-2.0
// Luminance and the two colour differences: the YIQ space of NTSC television, which the paper uses
// (section 3.3). Y = .299 R + .587 G + .114 B; I and Q are differences along orange-blue and
// purple-green. Pictures of one colour channel are their own luminance.
#pragma once

#include <array>
#include <vector>

#include "libstyle/image/image.h"

namespace libstyle::image {

// Y of every pixel: one channel. Alpha is left out.
Image luminance(const Image& image);

// The picture with another luminance: I, Q and alpha stay. `y` has one channel and the same size.
// Colours that leave 0 .. 1 are left so: whoever writes a file of integers cuts them.
Image with_luminance(const Image& image, const Image& y);

// Mean and standard deviation of all samples of some one-channel pictures taken together.
struct Distribution {
  double mean = 0;
  double deviation = 0;
};
Distribution distribution(const std::vector<const Image*>& images);

// Luminance remapping (section 3.4): the linear map that gives samples distributed like `from` the
// mean and deviation of `to`. Where `from` has no deviation, only the mean is moved.
struct LinearMap {
  double factor = 1;
  double offset = 0;

  float operator()(float value) const { return static_cast<float>(factor * value + offset); }
};
LinearMap remapping(const Distribution& from, const Distribution& to);

}  // namespace libstyle::image
