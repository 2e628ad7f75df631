// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/feature_plane.h"

#include <algorithm>
#include <cassert>

#include "libstyle/image/lanes.h"

namespace libstyle::image {

// Windows are read in whole lanes, and so a little beyond their last pixel.
FeaturePlane::FeaturePlane(int width, int height, int channels, int border)
    : width_(width), height_(height), channels_(channels), border_(border) {
  samples_.resize(pixel_count() * channels + kLanes);
}

void FeaturePlane::put(const Image& picture, int y, int first_channel) {
  assert(first_channel + picture.channels <= channels_ && picture.width <= width_);
  if (picture.channels == 0) return;
  for (int row = -border_; row < picture.height + border_; ++row) {
    const int from_row = std::clamp(row, 0, picture.height - 1);
    for (int x = -border_; x < picture.width + border_; ++x) {
      const auto from = picture.pixel(std::clamp(x, 0, picture.width - 1), from_row);
      std::ranges::copy(from, features(index(x, y + row)) + first_channel);
    }
  }
}

}  // namespace libstyle::image
