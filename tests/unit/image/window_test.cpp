// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/support/pictures.h"

namespace libstyle::image {
namespace {

WindowSettings settings(int radius, int guides, int filtered, FilteredPart part) {
  return {.radius = radius,
          .guide_in_middle_only = false,
          .guide_shares = std::vector<double>(guides, 1.0 / std::max(guides, 1)),
          .filtered_channels = filtered,
          .filtered = part};
}

double total(const WindowWeights& window) {
  return std::accumulate(window.weights.begin(), window.weights.end(), 0.0);
}

TEST(Window, GivesEachPartTheSameWeightAtEveryScale) {
  for (const int radius : {1, 2, 3}) {
    for (const int guides : {1, 3}) {
      for (const auto part : {FilteredPart::kBefore, FilteredPart::kAround, FilteredPart::kWhole}) {
        EXPECT_NEAR(total(make_window(settings(radius, guides, 3, part))), 2, 1e-5);
      }
    }
  }
  EXPECT_NEAR(total(make_window(settings(0, 1, 1, FilteredPart::kBefore))), 1, 1e-6);
}

TEST(Window, CountsOfWhatIsFilteredOnlyWhatComesBefore) {
  const WindowWeights window = make_window(settings(2, 0, 1, FilteredPart::kBefore));
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 5; ++column) {
      const bool before = row < 2 || (row == 2 && column < 2);
      EXPECT_EQ(window.weights[std::size_t(row) * window.row_lanes + column] > 0, before);
    }
  }
}

TEST(Window, CountsOfAGuideOnlyTheMiddleWhenAsked) {
  WindowSettings middle = settings(2, 1, 0, FilteredPart::kBefore);
  middle.guide_in_middle_only = true;
  const WindowWeights window = make_window(middle);
  EXPECT_NEAR(window.weights[2 * std::size_t(window.row_lanes) + 2], 1, 1e-6);
  EXPECT_NEAR(total(window), 1, 1e-6);
}

TEST(Window, ClippedLosesWhatIsOutside) {
  const WindowWeights window = make_window(settings(2, 1, 1, FilteredPart::kWhole));
  const WindowWeights part = clipped(window, 2, 0, 1, 2, 2);
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 5; ++column) {
      const bool inside = column >= 2 && row >= 1;
      for (int c = 0; c < 2; ++c) {
        const std::size_t at = std::size_t(row) * window.row_lanes + column * 2 + c;
        EXPECT_EQ(part.weights[at], inside ? window.weights[at] : 0);
      }
    }
  }
}

TEST(WindowDistance, IsTheWeightedSumOfSquares) {
  const Image a = test::noise(9, 8, 3, 1);
  const Image b = test::noise(7, 10, 3, 2);
  FeaturePlane plane_a(9, 8, 3, 2);
  FeaturePlane plane_b(7, 10, 3, 2);
  plane_a.put(a, 0, 0);
  plane_b.put(b, 0, 0);
  const WindowWeights window = make_window(settings(2, 1, 2, FilteredPart::kAround));
  double expected = 0;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      for (int c = 0; c < 3; ++c) {
        const double difference = double{a.pixel(4 + dx, 3 + dy)[c]} - b.pixel(3 + dx, 6 + dy)[c];
        expected += window.weights[std::size_t(dy + 2) * window.row_lanes + (dx + 2) * 3 + c] *
                    difference * difference;
      }
    }
  }
  EXPECT_NEAR(window_distance(window, plane_a.window(plane_a.index(4, 3), 2), plane_a.row_floats(),
                              plane_b.window(plane_b.index(3, 6), 2), plane_b.row_floats()),
              expected, 1e-6);
}

TEST(FeaturePlane, RepeatsTheOutermostPixelsAround) {
  const Image image = test::noise(4, 3, 2, 1);
  FeaturePlane plane(4, 3, 2, 2);
  plane.put(image, 0, 0);
  for (int y = -2; y < 5; ++y) {
    for (int x = -2; x < 6; ++x) {
      const auto pixel = image.pixel(std::clamp(x, 0, 3), std::clamp(y, 0, 2));
      EXPECT_EQ(plane.features(plane.index(x, y))[1], pixel[1]);
      EXPECT_EQ(plane.column(plane.index(x, y)), x);
      EXPECT_EQ(plane.row(plane.index(x, y)), y);
    }
  }
}

}  // namespace
}  // namespace libstyle::image
