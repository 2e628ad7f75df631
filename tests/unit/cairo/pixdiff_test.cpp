// SPDX-License-Identifier: Apache-2.0
#include "tests/support/pixdiff.h"

#include <gtest/gtest.h>

namespace libstyle {
namespace {

Raster square_at(std::size_t left) {
  Raster image(20, 20, {255, 255, 255, 255});
  for (std::size_t y = 5; y < 15; ++y) {
    for (std::size_t x = left; x < left + 10; ++x) image.at(x, y) = {0, 0, 0, 255};
  }
  return image;
}

TEST(Pixdiff, APictureEqualsItself) {
  const DiffResult result = compare(square_at(5), square_at(5), {});
  EXPECT_TRUE(result.passed);
  EXPECT_EQ(result.bad, 0u);
}

TEST(Pixdiff, TheEnvelopeAllowsAShiftOfOnePixelButNotOfTwo) {
  const DiffBounds strict{24, 0, 255, false}, envelope{24, 0, 255, true};
  EXPECT_EQ(compare(square_at(5), square_at(6), strict).bad, 20u);
  EXPECT_TRUE(compare(square_at(5), square_at(6), envelope).passed);
  EXPECT_FALSE(compare(square_at(5), square_at(7), envelope).passed);
}

// Darker than anything near it in the other picture, and lighter: seen from either side.
TEST(Pixdiff, TheEnvelopeSeesAMissingDotFromBothSides) {
  const DiffBounds bounds{24, 0, 255, true};
  Raster dot = square_at(5);
  dot.at(2, 2) = {0, 0, 0, 255};
  EXPECT_FALSE(compare(dot, square_at(5), bounds).passed);
  EXPECT_FALSE(compare(square_at(5), dot, bounds).passed);
}

TEST(Pixdiff, AShareOfBadPixelsMayPassTheHardStopMayNot) {
  Raster actual = square_at(5);
  actual.at(0, 0) = {155, 255, 255, 255};
  EXPECT_FALSE(compare(square_at(5), actual, {10, 0, 255, false}).passed);
  EXPECT_TRUE(compare(square_at(5), actual, {10, 0.01, 255, false}).passed);
  EXPECT_FALSE(compare(square_at(5), actual, {10, 0.01, 99, false}).passed);
}

TEST(Pixdiff, PicturesOfDifferentSizesFail) {
  EXPECT_FALSE(compare(Raster(2, 2), Raster(2, 3), {255, 1, 255, true}).passed);
  EXPECT_TRUE(compare(Raster(2, 2), Raster(2, 3), {0, 0, 0, true, 1}).passed);
  EXPECT_FALSE(compare(Raster(2, 2), Raster(2, 4), {0, 0, 0, true, 1}).passed);
}

TEST(Pixdiff, TransparentPixelsDifferFromBlackOnes) {
  EXPECT_FALSE(compare(Raster(2, 2), Raster(2, 2, {0, 0, 0, 255}), {10, 0, 255, false}).passed);
}

TEST(Pixdiff, ThreePanelsStandSideBySide) {
  Raster actual = square_at(5);
  actual.at(0, 0) = {0, 0, 0, 255};
  const Raster panels = three_panels(square_at(5), actual, {10, 0, 255, false});
  EXPECT_EQ(panels.width, 3 * 20u + 8);
  EXPECT_EQ(panels.at(24, 0), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(panels.at(48, 0), (Pixel{0, 0, 0, 255}));
}

}  // namespace
}  // namespace libstyle
