// SPDX-License-Identifier: Apache-2.0
// Texture synthesis: analogies without A and B.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "libstyle/image/image_analogy.h"
#include "tests/support/pictures.h"

namespace libstyle {
namespace {

ImageAnalogyInput texture(Image filtered, int width, int height) {
  ImageAnalogyInput input;
  input.examples.push_back({{}, std::move(filtered)});
  input.width = width;
  input.height = height;
  return input;
}

// Stripes of 6 px, slanted.
Image stripes(int width, int height) {
  Image image(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.pixel(x, y)[0] = static_cast<float>(0.5 + 0.5 * std::sin((x + y) * 2 * M_PI / 6));
    }
  }
  return image;
}

TEST(Texture, IsMadeOfTheExampleAtTheSizeAskedFor) {
  const ImageAnalogyResult result =
      make_image_analogy(texture(test::noise(33, 20, 3, 1), 50, 61), {});
  EXPECT_EQ(result.filtered.width, 50);
  EXPECT_EQ(result.filtered.height, 61);
  EXPECT_EQ(result.filtered.channels, 3);
}

TEST(Texture, GoesOnAsTheExampleDoes) {
  ImageAnalogyParameters parameters;
  for (parameters.seed = 1; parameters.seed <= 20; ++parameters.seed) {
    const Image result = make_image_analogy(texture(stripes(48, 48), 64, 64), parameters).filtered;
    // Stripes of the example do not change along (1, -1).
    double change = 0;
    for (int y = 1; y < 64; ++y) {
      for (int x = 0; x < 63; ++x) {
        change += std::abs(result.pixel(x, y)[0] - result.pixel(x + 1, y - 1)[0]);
      }
    }
    EXPECT_LT(change / (63 * 63), 0.06) << "seed " << parameters.seed;
  }
}

TEST(Texture, IsAnotherWithAnotherSeedAndTheSameWithTheSame) {
  const ImageAnalogyInput input = texture(test::noise(40, 40, 1, 1), 40, 40);
  ImageAnalogyParameters parameters;
  const Image first = make_image_analogy(input, parameters).filtered;
  EXPECT_EQ(make_image_analogy(input, parameters).filtered, first);
  parameters.threads = 7;
  EXPECT_EQ(make_image_analogy(input, parameters).filtered, first);
  parameters.seed = 2;
  EXPECT_NE(make_image_analogy(input, parameters).filtered, first);
}

// A copy of the whole example would not be a new texture.
TEST(Texture, DoesNotGiveTheExampleBackWhole) {
  ImageAnalogyParameters parameters;
  for (parameters.seed = 1; parameters.seed <= 20; ++parameters.seed) {
    const ImageAnalogyResult result =
        make_image_analogy(texture(test::noise(64, 64, 1, 1), 64, 64), parameters);
    std::set<std::pair<int, int>> shifts;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        const SourcePixel& source = result.sources[std::size_t(y) * 64 + x];
        shifts.insert({source.x - x, source.y - y});
      }
    }
    EXPECT_GE(shifts.size(), 4u) << "seed " << parameters.seed;
  }
}

TEST(Texture, TakesTheSmallestPictures) {
  for (const int side : {1, 2, 4}) {
    const ImageAnalogyResult result =
        make_image_analogy(texture(test::noise(side, side, 3, 1), 9, 7), {});
    EXPECT_EQ(result.sources.size(), 63u);
  }
  EXPECT_EQ(make_image_analogy(texture(test::noise(20, 20, 3, 1), 1, 1), {}).sources.size(), 1u);
}

}  // namespace
}  // namespace libstyle
