// SPDX-License-Identifier: Apache-2.0
// Properties that must hold for many random inputs.
//
//   for_each_seed(100, [](std::uint64_t seed) {
//     RandomValues random(seed);
//     const Polyline curve = random_curve(random, 50);
//     EXPECT_EQ(...);
//   });
//
// The first seed that fails is named in the output and ends the loop; to look at it alone, run the
// test with LIBSTYLE_SEED=that seed.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>

#include "libstyle/base/random.h"

namespace libstyle {

inline void for_each_seed(std::uint64_t count,
                          const std::function<void(std::uint64_t seed)>& property) {
  if (const char* only = std::getenv("LIBSTYLE_SEED")) {
    property(std::strtoull(only, nullptr, 10));
    return;
  }
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    property(seed);
    if (::testing::Test::HasFailure()) return;
  }
}

// A RandomStream read in order, for tests.
class RandomValues {
 public:
  explicit RandomValues(std::uint64_t seed) : stream_(seed, 0) {}

  double uniform(double low, double high) { return low + (high - low) * stream_.uniform(next_++); }
  double normal(double deviation = 1) { return deviation * stream_.normal(next_++); }
  std::size_t below(std::size_t count) { return stream_.below(next_++, count); }
  bool chance(double probability) { return uniform(0, 1) < probability; }

 private:
  RandomStream stream_;
  std::uint64_t next_ = 0;
};

}  // namespace libstyle
