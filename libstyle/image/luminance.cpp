// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/luminance.h"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace libstyle::image {
namespace {

double luminance_of(std::span<const float> pixel, int colors) {
  if (colors == 1) return pixel[0];
  return 0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2];
}

}  // namespace

Image luminance(const Image& image) {
  Image result(image.width, image.height, 1);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      result.pixel(x, y)[0] =
          static_cast<float>(luminance_of(image.pixel(x, y), image.color_channels()));
    }
  }
  return result;
}

// In YIQ, red, green and blue all change by what Y changes by when I and Q stay.
Image with_luminance(const Image& image, const Image& y) {
  assert(y.width == image.width && y.height == image.height && y.channels == 1);
  Image result = image;
  const int colors = image.color_channels();
  for (int row = 0; row < image.height; ++row) {
    for (int x = 0; x < image.width; ++x) {
      const auto pixel = result.pixel(x, row);
      const double change = y.pixel(x, row)[0] - luminance_of(pixel, colors);
      for (int c = 0; c < colors; ++c) pixel[c] = static_cast<float>(pixel[c] + change);
    }
  }
  return result;
}

Distribution distribution(const std::vector<const Image*>& images) {
  double sum = 0;
  double count = 0;
  for (const Image* image : images) {
    for (const float value : image->samples) sum += value;
    count += static_cast<double>(image->samples.size());
  }
  if (count == 0) return {};
  const double mean = sum / count;
  double squares = 0;
  for (const Image* image : images) {
    for (const float value : image->samples) squares += (value - mean) * (value - mean);
  }
  return {mean, std::sqrt(squares / count)};
}

LinearMap remapping(const Distribution& from, const Distribution& to) {
  constexpr double kFlat = 1e-6;  // a deviation below this is rounding
  const double factor = from.deviation > kFlat ? to.deviation / from.deviation : 1;
  return {factor, to.mean - factor * from.mean};
}

}  // namespace libstyle::image
