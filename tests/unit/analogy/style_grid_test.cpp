// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/style_grid.h"

#include <gmock/gmock.h>

#include <numbers>

#include "libstyle/geometry/arc_length.h"
#include "tests/support/curves.h"

namespace libstyle {
namespace {

Example wavy_example() {
  ExamplePair pair;
  Polyline wave;
  for (int i = 0; i <= 2000; ++i) {
    wave.points.push_back({0.25 * i, 5 * std::sin(2 * std::numbers::pi * 0.25 * i / 20)});
  }
  pair.filtered = with_length_parameter(wave);
  pair.unfiltered = with_length_parameter(polyline("0 0, 500 0"));
  return Example({&pair, 1}, {});
}

TEST(StyleGrid, LongStraightLinesHaveTheStyleAtItsOwnSize) {
  const Example example = wavy_example();
  const StyleGrid grid(polyline("0 0, 1000 0"), example, {});
  EXPECT_EQ(grid.scale_at(100), 1);
  EXPECT_EQ(grid.mean_scale(), 1);
  EXPECT_NEAR(static_cast<double>(grid.steps()), 1000 / example.step(), 0.51);
}

TEST(StyleGrid, CoordinatesRunFromEndToEnd) {
  const Example example = wavy_example();
  for_each_seed(20, [&](std::uint64_t seed) {
    RandomValues random(seed);
    const Polyline line = random_stroke(random, 300);
    const StyleGrid grid(line, example, {});
    const auto steps = static_cast<double>(grid.steps());
    EXPECT_NEAR(grid.length_at(0), 0, 1e-9);
    EXPECT_NEAR(grid.length_at(steps), arc_length(line), 1e-9 * arc_length(line));
    double last = -1;
    for (double x = 0; x <= steps; x += 0.5) {
      EXPECT_GT(grid.length_at(x), last);
      last = grid.length_at(x);
      EXPECT_GT(grid.scale_at(x), 0);
      EXPECT_LE(grid.scale_at(x), 1);
    }
  });
}

TEST(StyleGrid, ShortLinesHaveTheStyleSmaller) {
  const Example example = wavy_example();
  const StyleGrid longer(polyline("0 0, 20 0"), example, {});
  const StyleGrid shorter(polyline("0 0, 10 0"), example, {});
  EXPECT_LT(longer.scale_at(0), 1);
  EXPECT_NEAR(shorter.scale_at(0), longer.scale_at(0) / 2, 1e-9);
  EXPECT_EQ(shorter.steps(), longer.steps());
}

TEST(StyleGrid, TightBendsHaveTheStyleSmaller) {
  const Example example = wavy_example();
  // A long straight line into a bend of radius 4, and a long way out.
  Polyline hairpin = polyline("0 0, 300 0");
  const Polyline bend = arc({300, 4}, 4, -std::numbers::pi / 2, std::numbers::pi / 2, 40);
  hairpin.points.insert(hairpin.points.end(), bend.points.begin() + 1, bend.points.end());
  hairpin.points.push_back({0, 8});
  const StyleGrid grid(hairpin, example, {});
  const auto steps = static_cast<double>(grid.steps());
  EXPECT_LT(grid.scale_at(steps / 2), 0.75);
  EXPECT_GT(grid.scale_at(steps / 4), 0.99);
  EXPECT_GT(grid.scale_at(3 * steps / 4), 0.99);
}

TEST(StyleGrid, TheSmallestScaleIsALimit) {
  const Example example = wavy_example();
  CurveAnalogyParameters parameters;
  parameters.smallest_scale = 1;
  const StyleGrid grid(polyline("0 0, 3 0"), example, parameters);
  EXPECT_EQ(grid.scale_at(0), 1);
  EXPECT_EQ(grid.steps(), static_cast<std::size_t>(std::max(1.0, std::round(3 / example.step()))));
}

}  // namespace
}  // namespace libstyle
