// SPDX-License-Identifier: Apache-2.0
// The features of a grid of pixels, laid out so that a window round any pixel can be read without
// a question where the grid ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libstyle/image/image.h"

namespace libstyle::image {

// The number of a pixel in a plane, border included: one to the right is + 1, one down is
// + stride(). So is a shift of a whole window.
using PixelIndex = std::int32_t;

// The features of a pixel lie side by side, as do the pixels of a row, and all round is a border.
class FeaturePlane {
 public:
  FeaturePlane() = default;
  FeaturePlane(int width, int height, int channels, int border);

  int width() const { return width_; }
  int height() const { return height_; }
  int channels() const { return channels_; }
  int border() const { return border_; }
  int stride() const { return width_ + 2 * border_; }  // pixels from one row to the next
  std::ptrdiff_t row_floats() const { return std::ptrdiff_t{stride()} * channels_; }
  std::size_t pixel_count() const {
    return static_cast<std::size_t>(stride()) * (height_ + 2 * border_);
  }

  // Of the pixel in column x of row y, where -border <= x < width + border, and y alike.
  PixelIndex index(int x, int y) const { return (y + border_) * stride() + x + border_; }
  int column(PixelIndex pixel) const { return pixel % stride() - border_; }
  int row(PixelIndex pixel) const { return pixel / stride() - border_; }

  float* features(PixelIndex pixel) { return &samples_[std::size_t(pixel) * channels_]; }
  const float* features(PixelIndex pixel) const {
    return &samples_[std::size_t(pixel) * channels_];
  }

  // The first feature of the window of this radius round a pixel. Its rows are row_floats() apart.
  const float* window(PixelIndex pixel, int radius) const {
    return features(pixel - radius * (stride() + 1));
  }

  // Puts a picture into channels first .. first + picture.channels - 1, from (0, y) on, and copies
  // of its outermost pixels into the border round it.
  void put(const Image& picture, int y, int first_channel);

 private:
  int width_ = 0;
  int height_ = 0;
  int channels_ = 0;
  int border_ = 0;
  std::vector<float> samples_;
};

}  // namespace libstyle::image
