// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/arc_length.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;

TEST(ArcLength, AddsUpTheSegments) {
  EXPECT_THAT(cumulative_lengths(polyline("0 0, 3 4, 3 5")), ElementsAre(0, 5, 6));
  EXPECT_THAT(cumulative_lengths(polyline("0 0, 3 0, 3 4 z")), ElementsAre(0, 3, 7, 12));
  EXPECT_THAT(cumulative_lengths(polyline("7 7")), ElementsAre(0));
  EXPECT_TRUE(cumulative_lengths({}).empty());
}

TEST(ArcLength, OfACircleTendsToTwoPi) {
  EXPECT_NEAR(arc_length(circle({5, 5}, 1, 10000)), 2 * std::numbers::pi, 1e-6);
}

TEST(ArcLength, FindsPlacesByLength) {
  const ArcLength along(polyline("0 0, 3 4, 3 5"));
  EXPECT_EQ(along.place_at(2.5), (PolylinePlace{0, 0.5}));
  EXPECT_EQ(along.place_at(5), (PolylinePlace{1, 0}));
  EXPECT_EQ(along.place_at(6), (PolylinePlace{1, 1}));
  EXPECT_EQ(along.point_at(5.5), (Point{3, 4.5}));
}

TEST(ArcLength, StopsAtOpenEndsAndGoesRoundClosedCurves) {
  const ArcLength open(polyline("0 0, 4 0"));
  EXPECT_EQ(open.point_at(-1), (Point{0, 0}));
  EXPECT_EQ(open.point_at(9), (Point{4, 0}));
  const ArcLength closed(polyline("0 0, 4 0, 4 4, 0 4 z"));
  EXPECT_EQ(closed.point_at(-1), (Point{0, 1}));
  EXPECT_EQ(closed.point_at(16 + 3), (Point{3, 0}));
  EXPECT_EQ(closed.place_at(16), (PolylinePlace{0, 0}));
}

TEST(ArcLength, PassesOverRepeatedPoints) {
  const ArcLength along(polyline("0 0, 0 0, 2 0, 2 0, 2 0, 2 2, 2 2"));
  EXPECT_EQ(along.place_at(0), (PolylinePlace{1, 0}));
  EXPECT_EQ(along.place_at(2), (PolylinePlace{4, 0}));
  EXPECT_EQ(along.place_at(4), (PolylinePlace{4, 1}));
  EXPECT_EQ(along.tangent_at(2), (Vector{0, 1}));
  EXPECT_EQ(along.tangent_at(1.9), (Vector{1, 0}));
}

TEST(ArcLength, OfOnePointHasOnePlace) {
  const ArcLength along(polyline("3 4"));
  EXPECT_EQ(along.point_at(1), (Point{3, 4}));
  EXPECT_EQ(along.tangent_at(0), Vector{});
}

TEST(ArcLength, LengthToIsTheInverseOfPlaceAt) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    Polyline curve = random_scribble(random, 30, 10);
    curve.closed = seed % 2 == 1;
    const ArcLength along(curve);
    for (int i = 0; i < 20; ++i) {
      const double length = random.uniform(0, along.total());
      ASSERT_NEAR(along.length_to(along.place_at(length)), length, 1e-12 * along.total());
    }
  });
}

}  // namespace
}  // namespace libstyle
