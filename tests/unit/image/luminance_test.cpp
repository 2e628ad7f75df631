// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/luminance.h"

#include <gtest/gtest.h>

#include "tests/support/pictures.h"

namespace libstyle::image {
namespace {

TEST(Luminance, WeighsTheColorsAsYiqDoes) {
  Image image(3, 1, 3);
  for (int i = 0; i < 3; ++i) image.pixel(i, 0)[i] = 1;
  const Image y = luminance(image);
  EXPECT_FLOAT_EQ(y.pixel(0, 0)[0], 0.299F);
  EXPECT_FLOAT_EQ(y.pixel(1, 0)[0], 0.587F);
  EXPECT_FLOAT_EQ(y.pixel(2, 0)[0], 0.114F);
}

TEST(Luminance, ItsOwnChangesNothing) {
  const Image image = test::noise(8, 5, 4, 2);
  const Image same = with_luminance(image, luminance(image));
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    EXPECT_NEAR(same.samples[i], image.samples[i], 1e-6);
  }
}

TEST(Luminance, AnotherIsTakenOnWithColorsAndAlphaKept) {
  const Image image = test::noise(8, 5, 4, 2);
  const Image wanted = test::noise(8, 5, 1, 3);
  const Image changed = with_luminance(image, wanted);
  const Image y = luminance(changed);
  for (int row = 0; row < 5; ++row) {
    for (int x = 0; x < 8; ++x) {
      const auto before = image.pixel(x, row);
      const auto after = changed.pixel(x, row);
      EXPECT_NEAR(y.pixel(x, row)[0], wanted.pixel(x, row)[0], 1e-6);
      EXPECT_NEAR(after[0] - after[1], before[0] - before[1], 1e-6);
      EXPECT_NEAR(after[1] - after[2], before[1] - before[2], 1e-6);
      EXPECT_EQ(after[3], before[3]);
    }
  }
}

TEST(Remapping, GivesTheMeanAndDeviationOfTheOther) {
  Image a = test::noise(30, 20, 1, 1);
  Image b = test::noise(10, 15, 1, 2);
  for (float& sample : b.samples) sample = 0.2F + 0.3F * sample;
  const LinearMap map = remapping(distribution({&a}), distribution({&b}));
  for (float& sample : a.samples) sample = map(sample);
  const Distribution mapped = distribution({&a});
  const Distribution wanted = distribution({&b});
  EXPECT_NEAR(mapped.mean, wanted.mean, 1e-6);
  EXPECT_NEAR(mapped.deviation, wanted.deviation, 1e-6);
}

TEST(Remapping, OfOneColorOnlyMovesIt) {
  const Image flat = test::flat(4, 4, 1, 0.75F);
  const Image b = test::noise(9, 9, 1, 2);
  const LinearMap map = remapping(distribution({&flat}), distribution({&b}));
  EXPECT_EQ(map.factor, 1);
  EXPECT_NEAR(map(0.75F), distribution({&b}).mean, 1e-6);
}

}  // namespace
}  // namespace libstyle::image
