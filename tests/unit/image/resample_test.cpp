// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/resample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/support/pictures.h"

namespace libstyle::image {
namespace {

TEST(Halved, IsTheKernelOverBothAxes) {
  const Image image = test::noise(9, 7, 2, 3);
  const Image half = halved(image, 1);
  ASSERT_EQ(half.width, 5);
  ASSERT_EQ(half.height, 4);
  constexpr std::array<double, 5> kKernel = {1, 4, 6, 4, 1};
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (int c = 0; c < 2; ++c) {
        double sum = 0;
        for (int j = 0; j < 5; ++j) {
          for (int i = 0; i < 5; ++i) {
            sum += kKernel[i] * kKernel[j] / 256 *
                   image.pixel(std::clamp(2 * x + i - 2, 0, 8), std::clamp(2 * y + j - 2, 0, 6))[c];
          }
        }
        EXPECT_NEAR(half.pixel(x, y)[c], sum, 1e-6);
      }
    }
  }
}

TEST(Halved, KeepsOneColor) {
  EXPECT_EQ(halved(test::flat(10, 3, 3, 0.25F), 1), test::flat(5, 2, 3, 0.25F));
}

TEST(Halved, OfOnePixelIsOnePixel) {
  EXPECT_EQ(halved(test::flat(1, 1, 1, 0.5F), 1), test::flat(1, 1, 1, 0.5F));
}

}  // namespace
}  // namespace libstyle::image
