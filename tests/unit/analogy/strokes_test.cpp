// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/strokes.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/support/curves.h"

namespace libstyle {
namespace {

TEST(Strokes, BelongToTheLineTheyLieAlong) {
  const std::vector<Polyline> lines = {polyline("0 0, 100 0"), polyline("0 20, 100 20")};
  const std::vector<Polyline> strokes = {polyline("5 19, 40 22"), polyline("0 1, 50 -2"),
                                         polyline("60 18, 90 21"), polyline("0 9, 100 13")};
  EXPECT_THAT(lines_of_strokes(lines, strokes), testing::ElementsAre(1, 0, 1, 1));
}

TEST(Strokes, LieOnTheirStretchOfTheLine) {
  const Polyline line = polyline("0 0, 100 0, 100 100");
  for (const char* text : {"20 2, 60 -1", "60 -1, 20 2"}) {
    const SampledCurve laid = laid_along(with_length_parameter(polyline(text)), line);
    EXPECT_EQ(laid.polyline, polyline("20 2, 60 -1"));
    EXPECT_NEAR(laid.t.front(), 20, 1e-9);
    EXPECT_NEAR(laid.t.back(), 60, 1e-9);
  }
  const SampledCurve round = laid_along(with_length_parameter(polyline("80 1, 99 2, 98 30")), line);
  EXPECT_NEAR(round.t.front(), 80, 1e-9);
  EXPECT_NEAR(round.t.back(), 130, 1e-9);
  EXPECT_NEAR(round.t[1], 99, 4);
}

TEST(Strokes, TakeTheirValuesAlongWhenTheyAreTurned) {
  SampledCurve stroke = with_length_parameter(polyline("60 0, 30 0, 20 0"));
  stroke.channels = {{1, 2, 3}};
  const SampledCurve laid = laid_along(stroke, polyline("0 0, 100 0"));
  EXPECT_THAT(laid.channels[0], testing::ElementsAre(3, 2, 1));
  EXPECT_TRUE(std::ranges::is_sorted(laid.t));
}

TEST(Strokes, AcrossTheLineStillRise) {
  const SampledCurve laid =
      laid_along(with_length_parameter(polyline("50 -8, 50 0, 50 8")), polyline("0 0, 100 0"));
  EXPECT_NEAR(laid.t[1], 50, 1e-9);
  EXPECT_LT(laid.t[0], laid.t[1]);
  EXPECT_LT(laid.t[1], laid.t[2]);
  EXPECT_LT(laid.t[2] - laid.t[0], 2);
}

// As many lanes as there are strokes over the place with the most of them.
TEST(Strokes, AreInTheFewestLanes) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    std::vector<Lane::Stroke> strokes(30);
    for (Lane::Stroke& stroke : strokes) {
      stroke.begin = random.uniform(0, 100);
      stroke.end = stroke.begin + random.uniform(1, 20);
    }
    const std::vector<std::size_t> lanes = assign_lanes(strokes);
    std::size_t most = 0;
    for (std::size_t i = 0; i < 30; ++i) {
      std::size_t above = 0;
      for (std::size_t k = 0; k < 30; ++k) {
        const bool covers =
            strokes[k].begin <= strokes[i].begin && strokes[i].begin <= strokes[k].end;
        above += covers;
        EXPECT_TRUE(k == i || !covers || lanes[i] != lanes[k]);
      }
      most = std::max(most, above);
    }
    EXPECT_EQ(std::ranges::max(lanes) + 1, most);
  });
}

}  // namespace
}  // namespace libstyle
