// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <exception>
#include <mutex>

#include "libstyle/base/thread_count.h"

namespace libstyle {
namespace {

// Keeps the failure with the lowest index, so that the message too is the same on any number of
// threads.
class FirstFailure {
 public:
  bool precedes(std::size_t index) {
    const std::lock_guard lock(mutex_);
    return failure_ && index_ < index;
  }

  void record(std::size_t index) {
    const std::lock_guard lock(mutex_);
    if (failure_ && index_ <= index) return;
    failure_ = std::current_exception();
    index_ = index;
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::size_t index_ = 0;
};

}  // namespace

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  const std::size_t most = thread_count(threads);
  if (most == 1 || count < 2) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  FirstFailure failure;
  // More threads than cores are allowed, and TBB says so on stderr unless told that they are.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, most);
  tbb::task_arena arena(static_cast<int>(most));
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      if (failure.precedes(i)) return;
      try {
        work(i);
      } catch (...) {
        failure.record(i);
      }
    });
  });
  failure.rethrow();
}

}  // namespace libstyle
