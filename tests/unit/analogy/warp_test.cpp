// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/warp.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "tests/support/matchers.h"
#include "tests/support/seeds.h"

namespace libstyle {
namespace {

TEST(Warp, MovesEveryTargetByItsOffset) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    std::vector<WarpTarget> targets;
    double position = 0;
    for (std::size_t i = 0; i < 1 + seed % 30; ++i) {
      targets.push_back({position, {random.normal(5), random.normal(5)}});
      position += std::pow(10, random.uniform(-9, 2));  // far apart and very near
    }
    const Warp warp(targets, 7);
    for (const WarpTarget& target : targets) {
      EXPECT_THAT(warp.at(target.position), PointNear(target.offset, 0));
    }
  });
}

TEST(Warp, IsNeverLargerThanItsTargets) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    std::vector<WarpTarget> targets;
    double largest = 0;
    for (int i = 0; i < 40; ++i) {
      targets.push_back({random.uniform(0, 30), {random.normal(5), random.normal(5)}});
      largest = std::max(largest, norm(targets.back().offset));
    }
    const Warp warp(targets, 7);
    for (double x = -20; x < 50; x += 0.01) EXPECT_LE(norm(warp.at(x)), largest * (1 + 1e-12));
  });
}

TEST(Warp, FadesAwayFromItsTargets) {
  const WarpTarget target[] = {{10, {3, -2}}};
  const Warp warp(target, 2);
  EXPECT_THAT(warp.at(30), PointNear({0, 0}, 1e-12));
  EXPECT_LT(norm(warp.at(13)), norm(warp.at(12)));
}

TEST(Warp, TakesTargetsAtOnePlaceForOne) {
  const WarpTarget targets[] = {{10, {3, 0}}, {10, {4, 0}}, {20, {0, 1}}};
  const Warp warp(targets, 5);
  EXPECT_THAT(warp.at(10), PointNear({3, 0}, 1e-9));
  EXPECT_THAT(warp.at(20), PointNear({0, 1}, 1e-9));
}

TEST(Warp, WithoutTargetsMovesNothing) { EXPECT_EQ(Warp({}, 1).at(3), Vector{}); }

}  // namespace
}  // namespace libstyle
