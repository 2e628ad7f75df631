// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/sampled_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;

// A random curve, open or closed, with a channel that equals t on open curves.
SampledCurve random_curve(std::uint64_t seed) {
  RandomValues random(seed);
  Polyline points = random_stroke(random, 5 + random.below(60));
  points.closed = seed % 2 == 1;
  SampledCurve curve = with_length_parameter(std::move(points));
  curve.channels.push_back(curve.t);
  return curve;
}

TEST(Resample, KeepsEndPoints) {
  for_each_seed(100, [](std::uint64_t seed) {
    const SampledCurve curve = random_curve(seed);
    RandomValues random(seed + 1000);
    const SampledCurve even = resample(curve, random.uniform(0.05, 20));
    ASSERT_EQ(even.polyline.points.front(), curve.polyline.points.front());
    ASSERT_EQ(even.t.front(), 0);
    if (curve.polyline.closed) {
      ASSERT_EQ(resample_to_count(curve, 17).size(), 17u);
      return;
    }
    ASSERT_EQ(even.polyline.points.back(), curve.polyline.points.back());
    ASSERT_EQ(even.t.back(), 1);
    ASSERT_EQ(resample_to_count(curve, 17).polyline.points.back(), curve.polyline.points.back());
  });
}

TEST(Resample, KeepsChosenParametersBitForBit) {
  for_each_seed(100, [](std::uint64_t seed) {
    const SampledCurve curve = random_curve(seed);
    RandomValues random(seed + 1000);
    std::vector<double> kept;
    for (int i = 0; i < 5; ++i) kept.push_back(random.uniform(0, 1));
    kept.push_back(kept.front());
    kept.push_back(curve.t[3]);
    const SampledCurve even = resample(curve, random.uniform(0.05, 20), kept);
    for (const double t : kept) {
      const auto found = std::ranges::find(even.t, t);
      ASSERT_NE(found, even.t.end());
      ASSERT_EQ(even.polyline.points[static_cast<std::size_t>(found - even.t.begin())],
                point_at_parameter(curve, t));
    }
    ASSERT_EQ(std::ranges::count(even.t, kept.front()), 1);
  });
}

TEST(Resample, CarriesParameterAndChannelsInOrder) {
  for_each_seed(100, [](std::uint64_t seed) {
    const SampledCurve curve = random_curve(seed);
    const std::vector<double> kept = {0.3, 0.7};
    const SampledCurve even = resample(curve, 0.3, kept);
    ASSERT_TRUE(std::ranges::is_sorted(even.t));
    for (std::size_t i = 0; i < even.size(); ++i) {
      ASSERT_THAT(even.polyline.points[i], PointNear(point_at_parameter(curve, even.t[i]), 1e-9));
      // The closing segment leads the channel back from t.back() to 0.
      if (even.t[i] > curve.t.back()) continue;
      ASSERT_NEAR(even.channels[0][i], even.t[i], 1e-12);
    }
  });
}

TEST(Resample, SpacesEvenlyBetweenKeptVertices) {
  const SampledCurve even = resample(with_length_parameter(polyline("0 0, 10 0")), 1.0, {{0.24}});
  Polyline expected;  // 2.4 in two steps, 7.6 in eight
  for (int i = 0; i < 2; ++i) expected.points.push_back({1.2 * i, 0});
  for (int i = 0; i <= 8; ++i) expected.points.push_back({2.4 + 0.95 * i, 0});
  EXPECT_THAT(even.polyline, PolylineNear(expected, 1e-12));
}

TEST(Resample, OfAClosedCurveGoesRoundEvenly) {
  const Polyline even = resample(polyline("0 0, 4 0, 4 4, 0 4 z"), 2);
  EXPECT_THAT(even, PolylineNear(polyline("0 0, 2 0, 4 0, 4 2, 4 4, 2 4, 0 4, 0 2 z"), 1e-12));
  EXPECT_EQ(resample(polyline("0 0, 4 0, 4 4, 0 4 z"), 1000).points.size(), 3u);
}

TEST(Resample, LeavesASinglePointAlone) {
  EXPECT_EQ(resample(polyline("3 4"), 1), polyline("3 4"));
  EXPECT_EQ(resample(Polyline{}, 1), Polyline{});
  EXPECT_EQ(resample(polyline("3 4, 3 4, 3 4"), 1), polyline("3 4, 3 4"));
}

TEST(Resample, RefusesMoreSamplesThanMemoryHolds) {
  EXPECT_THROW(resample(polyline("0 0, 1e9 0"), 1e-3), Error);
}

TEST(PlaceAtParameter, TakesTheFirstWhereTheParameterStandsStill) {
  const SampledCurve curve{polyline("0 0, 1 0, 2 0, 3 0"), {0, 0.5, 0.5, 1}, {}};
  EXPECT_EQ(place_at_parameter(curve, 0.5), (PolylinePlace{0, 1}));
  EXPECT_EQ(point_at_parameter(curve, 0.75), (Point{2.5, 0}));
  EXPECT_EQ(point_at_parameter(curve, 7), (Point{3, 0}));
  EXPECT_EQ(point_at_parameter(curve, -7), (Point{0, 0}));
}

TEST(PlaceAtParameter, GoesRoundClosedCurves) {
  const SampledCurve curve = with_length_parameter(polyline("0 0, 4 0, 4 4, 0 4 z"));
  EXPECT_THAT(point_at_parameter(curve, 0.875), PointNear({0, 2}, 1e-12));
  EXPECT_THAT(point_at_parameter(curve, -0.125), PointNear({0, 2}, 1e-12));
  EXPECT_THAT(point_at_parameter(curve, 3.125), PointNear({2, 0}, 1e-12));
}

TEST(WithoutRepeatedPoints, KeepsTheEnds) {
  EXPECT_EQ(without_repeated_points(polyline("0 0, 0 0, 1 0, 1 0, 2 0, 2 0")),
            polyline("0 0, 1 0, 2 0"));
  EXPECT_EQ(without_repeated_points(polyline("0 0, 1 0, 2 0, 2.1 0"), 0.5),
            polyline("0 0, 1 0, 2.1 0"));
  EXPECT_EQ(without_repeated_points(polyline("0 0, 1 0, 1 1, 0 0 z")), polyline("0 0, 1 0, 1 1 z"));
  EXPECT_EQ(without_repeated_points(polyline("5 5, 5 5, 5 5")), polyline("5 5"));
}

TEST(WithoutRepeatedPoints, LeavesOnlySegmentsLongerThanTheTolerance) {
  for_each_seed(100, [](std::uint64_t seed) {
    const SampledCurve curve = random_curve(seed);
    const SampledCurve fewer = without_repeated_points(curve, 1.0);
    for (std::size_t i = 0; i < segment_count(fewer.polyline); ++i) {
      ASSERT_GT(distance(segment_start(fewer.polyline, i), segment_end(fewer.polyline, i)), 1.0);
    }
    ASSERT_EQ(fewer.t, fewer.channels[0]);
    const bool has_end = !curve.polyline.closed && fewer.size() > 1;
    ASSERT_EQ(fewer.t.back(), has_end ? 1 : fewer.t.back());
  });
}

}  // namespace
}  // namespace libstyle
