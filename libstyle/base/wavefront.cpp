// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/wavefront.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "libstyle/base/parallel.h"
#include "libstyle/base/thread_count.h"

namespace libstyle {
namespace {

constexpr int kPiece = 16;

// How far a row is; on a cache line of its own, for the row below looks at it all the time.
struct alignas(64) Done {
  std::atomic<int> columns = 0;
};

void wait_for(const Done& done, int columns, const std::atomic<bool>& failed) {
  for (int turn = 0; done.columns.load(std::memory_order_acquire) < columns; ++turn) {
    if (failed.load(std::memory_order_relaxed)) return;
    if (turn > 200) std::this_thread::yield();  // more threads than cores: let the row above run
  }
}

}  // namespace

void wavefront(int rows, int columns, int reach, int threads,
               const std::function<void(int, int, int)>& work) {
  std::vector<Done> done(static_cast<std::size_t>(std::max(rows, 0)));
  std::atomic<int> next_row = 0;
  std::atomic<bool> failed = false;
  const auto do_row = [&](int row) {
    for (int begin = 0; begin < columns; begin += kPiece) {
      const int end = std::min(begin + kPiece, columns);
      if (row > 0) wait_for(done[row - 1], std::min(end + reach, columns), failed);
      if (failed.load(std::memory_order_relaxed)) return;
      work(row, begin, end);
      done[row].columns.store(end, std::memory_order_release);
    }
  };
  // Rows are taken from the top, so the row above one that is being worked on is being worked on
  // too, or done: no thread waits for work that no thread has.
  const auto do_rows = [&](std::size_t) {
    try {
      for (int row = next_row++; row < rows; row = next_row++) do_row(row);
    } catch (...) {
      failed = true;
      throw;
    }
  };
  const std::size_t most = std::min<std::size_t>(thread_count(threads), std::max(rows, 1));
  parallel_for(most, static_cast<int>(most), do_rows);
}

}  // namespace libstyle
