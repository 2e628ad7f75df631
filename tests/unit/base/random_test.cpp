// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace libstyle {
namespace {

TEST(Random, IsAFunctionOfSeedStreamAndIndex) {
  const RandomStream stream(7, 3);
  const RandomStream same(7, 3);
  EXPECT_EQ(stream.bits(41), same.bits(41));
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    for (std::uint64_t place = 0; place < 4; ++place) {
      for (std::uint64_t index = 0; index < 4; ++index) {
        seen.insert(RandomStream(seed, place).bits(index));
      }
    }
  }
  EXPECT_EQ(seen.size(), 64u);
}

// The published test vector of Philox4x32-10 for counter and key of all zeros.
TEST(Random, AgreesWithThePublishedPhiloxVector) {
  EXPECT_EQ(RandomStream(0, 0).bits(0), 0xe169c58d6627e8d5ull);
}

TEST(Random, UniformHasTheMomentsOfTheUnitInterval) {
  const RandomStream stream(1, 0);
  constexpr int kCount = 100000;
  double sum = 0, squares = 0;
  for (int i = 0; i < kCount; ++i) {
    const double value = stream.uniform(static_cast<std::uint64_t>(i));
    ASSERT_GE(value, 0);
    ASSERT_LT(value, 1);
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / kCount, 0.5, 0.005);
  EXPECT_NEAR(squares / kCount, 1.0 / 3, 0.005);
}

TEST(Random, NormalHasMeanZeroAndVarianceOne) {
  const RandomStream stream(1, 0);
  constexpr int kCount = 100000;
  double sum = 0, squares = 0;
  for (int i = 0; i < kCount; ++i) {
    const double value = stream.normal(static_cast<std::uint64_t>(i));
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / kCount, 0, 0.015);
  EXPECT_NEAR(squares / kCount, 1, 0.02);
}

TEST(Random, BelowReachesEveryValueEvenly) {
  const RandomStream stream(5, 0);
  std::array<int, 7> counts{};
  for (std::uint64_t i = 0; i < 70000; ++i) ++counts[stream.below(i, counts.size())];
  for (const int count : counts) EXPECT_NEAR(count, 10000, 400);
}

TEST(Random, ChooseFollowsTheWeightsAndNeverTakesZero) {
  const RandomStream stream(5, 1);
  const std::vector<double> weights = {0, 1, 0, 3, 0};
  std::array<int, 5> counts{};
  for (std::uint64_t i = 0; i < 40000; ++i) ++counts[stream.choose(i, weights)];
  EXPECT_EQ(counts[0] + counts[2] + counts[4], 0);
  EXPECT_NEAR(counts[1], 10000, 400);
}

}  // namespace
}  // namespace libstyle
