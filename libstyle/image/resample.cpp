// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/resample.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "libstyle/base/parallel.h"

namespace libstyle::image {
namespace {

constexpr std::array<float, 5> kKernel = {1.F / 16, 4.F / 16, 6.F / 16, 4.F / 16, 1.F / 16};

// Row 2 y of the image, blurred downwards only.
void blur_down(const Image& image, int y, std::vector<float>& row) {
  const std::size_t size = row.size();
  std::ranges::fill(row, 0.F);
  for (int k = 0; k < 5; ++k) {
    const float weight = kKernel[k];
    const float* from = image.pixel(0, std::clamp(2 * y + k - 2, 0, image.height - 1)).data();
    for (std::size_t i = 0; i < size; ++i) row[i] += weight * from[i];
  }
}

}  // namespace

Image halved(const Image& image, int threads) {
  const int channels = image.channels;
  Image result((image.width + 1) / 2, (image.height + 1) / 2, channels);
  if (channels == 0) return result;
  parallel_for(static_cast<std::size_t>(result.height), threads, [&](std::size_t index) {
    const int y = static_cast<int>(index);
    std::vector<float> row(static_cast<std::size_t>(image.width) * channels);
    blur_down(image, y, row);
    for (int x = 0; x < result.width; ++x) {
      float* to = result.pixel(x, y).data();
      for (int k = 0; k < 5; ++k) {
        const int column = std::clamp(2 * x + k - 2, 0, image.width - 1);
        const float* from = &row[static_cast<std::size_t>(column) * channels];
        for (int c = 0; c < channels; ++c) to[c] += kKernel[k] * from[c];
      }
    }
  });
  return result;
}

}  // namespace libstyle::image
