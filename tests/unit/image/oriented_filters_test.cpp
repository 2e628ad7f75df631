// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/oriented_filters.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/pictures.h"

namespace libstyle::image {
namespace {

// A dark and a bright half, with the border through the middle at `angle`.
Image edge(double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180;
  Image image(21, 21, 1);
  for (int y = 0; y < 21; ++y) {
    for (int x = 0; x < 21; ++x) {
      const double u = (x - 10) * std::cos(angle) + (y - 10) * std::sin(angle);
      image.pixel(x, y)[0] = static_cast<float>(1 / (1 + std::exp(-2 * u)));
    }
  }
  return image;
}

TEST(OrientedResponses, AreNoneInOneColor) {
  const Image responses = oriented_responses(test::flat(12, 9, 1, 0.7F), 1);
  for (const float response : responses.samples) EXPECT_NEAR(response, 0, 1e-6);
}

TEST(OrientedResponses, AreLargestAcrossAnEdge) {
  for (int direction = 0; direction < 4; ++direction) {
    const Image responses = oriented_responses(edge(45.0 * direction), 1);
    const auto middle = responses.pixel(10, 10);
    for (int other = 0; other < 4; ++other) {
      if (other != direction) {
        EXPECT_GT(std::abs(middle[direction]), std::abs(middle[other]) + 0.01F);
      }
    }
  }
}

TEST(OrientedResponses, ChangeTheirSignWithTheSides) {
  const float there = oriented_responses(edge(0), 1).pixel(10, 10)[0];
  const float back = oriented_responses(edge(180), 1).pixel(10, 10)[0];
  EXPECT_NEAR(there, -back, 1e-6);
  EXPECT_GT(std::abs(there), 0.1F);
}

TEST(OrientedResponses, TurnWithThePicture) {
  const Image image = test::noise(15, 15, 1, 4);
  Image turned(15, 15, 1);  // by 90 degrees: x' = 14 - y, y' = x
  for (int y = 0; y < 15; ++y) {
    for (int x = 0; x < 15; ++x) turned.pixel(14 - y, x)[0] = image.pixel(x, y)[0];
  }
  const auto before = oriented_responses(image, 1);
  const auto after = oriented_responses(turned, 1);
  EXPECT_NEAR(after.pixel(7, 7)[2], before.pixel(7, 7)[0], 1e-6);  // along 90 instead of 0
  EXPECT_NEAR(after.pixel(7, 7)[3], before.pixel(7, 7)[1], 1e-6);  // along 135 instead of 45
}

}  // namespace
}  // namespace libstyle::image
