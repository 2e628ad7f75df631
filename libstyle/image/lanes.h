// SPDX-License-Identifier: Apache-2.0
// Four floats at a time, in the same order on every machine.
//
// Sums of floats depend on their order, so a compiler may not spread them over the lanes of its
// registers; it has to be said. Four lanes are what every x86-64 and ARMv8 machine has, and wider
// ones give the same bytes, for the lanes are what the source says.
#pragma once

#include <cstring>

namespace libstyle::image {

constexpr int kLanes = 4;
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));

inline Lanes load_lanes(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

inline void store_lanes(float* to, Lanes lanes) { std::memcpy(to, &lanes, sizeof lanes); }

inline Lanes all_lanes(float value) { return Lanes{value, value, value, value}; }

inline Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }
inline Lanes smaller(Lanes a, Lanes b) { return a < b ? a : b; }

inline float sum_of_lanes(Lanes lanes) { return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]); }

// `count` rounded up to whole lanes.
constexpr int whole_lanes(int count) { return (count + kLanes - 1) / kLanes * kLanes; }

}  // namespace libstyle::image
