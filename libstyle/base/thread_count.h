// SPDX-License-Identifier: Apache-2.0
// What a number of threads, as people give it, means.
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>

namespace libstyle {

// 0: one a core. At most 256: more are of no use here, and cost more than they bring or are
// refused.
inline std::size_t thread_count(int threads) {
  constexpr std::size_t kMost = 256;
  const std::size_t wanted =
      threads > 0 ? static_cast<std::size_t>(threads) : std::thread::hardware_concurrency();
  return std::clamp<std::size_t>(wanted, 1, kMost);
}

}  // namespace libstyle
