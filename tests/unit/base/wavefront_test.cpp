// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/wavefront.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

namespace libstyle {
namespace {

TEST(Wavefront, FindsTheCellsBeforeDoneAndThoseBelowNot) {
  constexpr int kRows = 60, kColumns = 150, kReach = 5;
  for (const int threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> done(kRows * kColumns);
    std::atomic<int> faults = 0;
    wavefront(kRows, kColumns, kReach, threads, [&](int row, int begin, int end) {
      for (int x = begin; x < end; ++x) {
        for (int above = std::max(0, row - 2); above < row; ++above) {
          const int last = std::min(x + kReach, kColumns - 1);
          for (int column = 0; column <= last; ++column) {
            if (!done[above * kColumns + column]) ++faults;
          }
        }
        if (x > 0 && !done[row * kColumns + x - 1]) ++faults;
        if (row + 1 < kRows) {
          for (int column = std::max(0, x - kReach); column < kColumns; ++column) {
            if (done[(row + 1) * kColumns + column]) ++faults;
          }
        }
        done[row * kColumns + x] = 1;
      }
    });
    EXPECT_EQ(faults, 0) << threads << " threads";
    EXPECT_TRUE(std::ranges::all_of(done, [](const auto& cell) { return cell == 1; }));
  }
}

TEST(Wavefront, HandsAnExceptionOn) {
  for (const int threads : {1, 3}) {
    EXPECT_THROW(wavefront(20, 40, 2, threads,
                           [](int row, int, int) {
                             if (row == 7) throw std::runtime_error("row 7");
                           }),
                 std::runtime_error);
  }
}

TEST(Wavefront, HasNothingToDoInAnEmptyGrid) {
  const auto fail = [](int, int, int) { FAIL(); };
  wavefront(0, 10, 2, 2, fail);
  wavefront(10, 0, 2, 2, fail);
}

}  // namespace
}  // namespace libstyle
