// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/window_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "libstyle/image/level.h"
#include "tests/support/pictures.h"

namespace libstyle::image {
namespace {

constexpr float kNoLimit = std::numeric_limits<float>::max();

// Windows of 3x3 in one channel: nine numbers, which nine components hold whole.
class WindowIndexOfNoise : public ::testing::Test {
 protected:
  WindowIndexOfNoise()
      : level_({{Image(40, 30, 0)}, {test::noise(40, 30, 1, 1)}, Image(20, 20, 0)}, 1) {
    neighborhood_.fine = make_window({.radius = 1,
                                      .guide_in_middle_only = false,
                                      .guide_shares = {},
                                      .filtered_channels = 1,
                                      .filtered = FilteredPart::kWhole});
    rows_ = {level_.examples.row_floats(), 0};
    queries_ = FeaturePlane(20, 20, 1, 1);
    queries_.put(test::noise(20, 20, 1, 2), 0, 0);
    query_rows_ = {queries_.row_floats(), 0};
  }

  WindowIndex index(int leaves, int threads = 2) const {
    return {neighborhood_,
            rows_,
            level_.places,
            [this](PixelIndex place) { return windows(place); },
            {.most_components = 9, .kept_variance = 1, .leaves = leaves, .threads = threads}};
  }

  Windows windows(PixelIndex place) const { return {level_.examples.window(place, 1)}; }
  Windows query(int number) const {
    return {queries_.window(queries_.index(number % 20, number / 20), 1)};
  }

  // The nearest places by definition.
  std::vector<NearPlace> nearest(int number, std::size_t count) const {
    std::vector<NearPlace> all;
    for (const PixelIndex place : level_.places) {
      all.push_back(
          {neighborhood_distance(neighborhood_, query(number), query_rows_, windows(place), rows_),
           place});
    }
    std::ranges::sort(all, {}, &NearPlace::distance);
    all.resize(count);
    return all;
  }

  Level level_;
  Neighborhood neighborhood_;
  RowSteps rows_;
  FeaturePlane queries_;
  RowSteps query_rows_;
};

TEST_F(WindowIndexOfNoise, FindsTheNearestWhenItLooksEverywhere) {
  const WindowIndex all = index(10000);
  std::array<NearPlace, 4> found;
  for (int number = 0; number < 400; ++number) {
    ASSERT_EQ(all.nearest(query(number), query_rows_, kNoLimit, found), found.size());
    const std::vector<NearPlace> expected = nearest(number, found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i].distance, expected[i].distance, 1e-5);
      EXPECT_EQ(found[i].place, expected[i].place);
    }
  }
}

TEST_F(WindowIndexOfNoise, FindsNothingBeyondTheLimit) {
  const WindowIndex all = index(10000);
  std::array<NearPlace, 4> found;
  for (int number = 0; number < 100; ++number) {
    const float nearest_distance = nearest(number, 1)[0].distance;
    EXPECT_EQ(all.nearest(query(number), query_rows_, nearest_distance * 0.99F, found), 0u);
    EXPECT_GE(all.nearest(query(number), query_rows_, nearest_distance * 1.01F, found), 1u);
  }
}

TEST_F(WindowIndexOfNoise, FindsEachPlaceItself) {
  const WindowIndex one_leaf = index(1);
  std::array<NearPlace, 1> found;
  for (const PixelIndex place : level_.places) {
    ASSERT_EQ(one_leaf.nearest(windows(place), rows_, kNoLimit, found), 1u);
    EXPECT_EQ(found[0].place, place);
  }
}

TEST_F(WindowIndexOfNoise, GetsBetterWithMoreLeaves) {
  std::array<NearPlace, 1> found;
  double before = std::numeric_limits<double>::max();
  for (const int leaves : {1, 4, 16, 64}) {
    const WindowIndex some = index(leaves);
    double sum = 0;
    for (int number = 0; number < 400; ++number) {
      some.nearest(query(number), query_rows_, kNoLimit, found);
      sum += found[0].distance;
    }
    EXPECT_LE(sum, before);
    before = sum;
  }
}

TEST_F(WindowIndexOfNoise, IsTheSameOnAnyNumberOfThreads) {
  std::array<NearPlace, 3> found;
  std::array<NearPlace, 3> again;
  const WindowIndex one = index(3, 1);
  const WindowIndex seven = index(3, 7);
  for (int number = 0; number < 400; ++number) {
    ASSERT_EQ(one.nearest(query(number), query_rows_, kNoLimit, found),
              seven.nearest(query(number), query_rows_, kNoLimit, again));
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].place, again[i].place);
      EXPECT_EQ(found[i].distance, again[i].distance);
    }
  }
}

}  // namespace
}  // namespace libstyle::image
