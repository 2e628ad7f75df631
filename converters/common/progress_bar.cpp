// SPDX-License-Identifier: Apache-2.0
#include "converters/common/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <mutex>

namespace libstyle {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds kPatience{1.0};
constexpr Seconds kPeriod{0.1};
constexpr int kCells = 30;

class ProgressBar {
 public:
  explicit ProgressBar(std::string program) : program_(std::move(program)) {}
  ~ProgressBar() { clear(); }

  void update(double done) {
    const std::lock_guard lock(mutex_);
    const Clock::time_point now = Clock::now();
    if (done >= 1) return clear();
    if (now - start_ < kPatience || now - drawn_ < kPeriod || done <= 0) return;
    drawn_ = now;
    const double left = Seconds(now - start_).count() * (1 - done) / done;
    const int full = std::clamp(static_cast<int>(done * kCells), 0, kCells);
    fmt::print(stderr, "\r{}: [{:#<{}}{:.<{}}] {:3.0f} %, {:.0f} s left\033[K", program_, "", full,
               "", kCells - full, 100 * done, left);
    std::fflush(stderr);
    visible_ = true;
  }

 private:
  void clear() {
    if (visible_) std::fputs("\r\033[K", stderr);
    visible_ = false;
  }

  std::string program_;
  std::mutex mutex_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_{};
  bool visible_ = false;
};

}  // namespace

bool stderr_is_terminal() { return isatty(STDERR_FILENO) != 0; }

ProgressHandler make_progress_bar(const std::string& program) {
  return [bar = std::make_shared<ProgressBar>(program)](double done) { bar->update(done); };
}

}  // namespace libstyle
