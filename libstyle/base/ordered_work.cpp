// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/ordered_work.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

#include "libstyle/base/thread_count.h"

namespace libstyle {
namespace {

using Stages = OrderedStages<const std::size_t>;

// What the threads share. Each does whatever can be done next, what is closest to the end of the
// line first, so that items leave as soon as they can.
class OrderedRun {
 public:
  OrderedRun(std::size_t threads, std::size_t slots, const Stages& stages)
      : threads_(threads), slots_(slots), stages_(stages) {}

  void run() {
    {
      std::unique_lock lock(mutex_);
      // Two items are read before anything else: who has only one needs no second thread.
      read(lock);
      read(lock);
    }
    help();
    for (std::thread& helper : helpers_) helper.join();  // is_over(): there will be no more
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  struct Slot {
    bool is_done = false;
    std::exception_ptr failure = nullptr;  // waits until it is its item's turn
  };

  void help() {
    std::unique_lock lock(mutex_);
    while (!is_over()) {
      if (can_write()) {
        write(lock);
      } else if (begun_ < read_) {
        work(lock);
      } else if (can_read()) {
        read(lock);
      } else {
        changed_.wait(lock);
      }
    }
  }

  bool can_write() const { return !writing_ && written_ < begun_ && slot(written_).is_done; }
  bool can_read() const { return !reading_ && !ended_ && read_ - written_ < slots_.size(); }
  bool is_over() const { return failure_ || (ended_ && written_ == read_); }

  void read(std::unique_lock<std::mutex>& lock) {
    if (ended_) return;
    reading_ = true;
    bool is_there = false;
    const std::exception_ptr failure =
        unlocked(lock, [&] { is_there = stages_.read(read_ % slots_.size()); });
    reading_ = false;
    ended_ = failure || !is_there;
    if (failure || is_there) slot(read_++) = {false, failure};
    changed_.notify_all();
  }

  void work(std::unique_lock<std::mutex>& lock) {
    const std::size_t item = begun_++;
    if (begun_ < read_ || can_read()) start_helper();  // there is more to do meanwhile
    if (!slot(item).failure) {
      slot(item).failure = unlocked(lock, [&] { stages_.work(item % slots_.size()); });
    }
    slot(item).is_done = true;
    changed_.notify_all();
  }

  void write(std::unique_lock<std::mutex>& lock) {
    writing_ = true;
    failure_ = slot(written_).failure;
    if (!failure_) failure_ = unlocked(lock, [&] { stages_.write(written_ % slots_.size()); });
    writing_ = false;
    ++written_;
    changed_.notify_all();
  }

  // Calls a stage while others go on. Returns what it throws.
  template <typename Stage>
  static std::exception_ptr unlocked(std::unique_lock<std::mutex>& lock, const Stage& stage) {
    std::exception_ptr failure;
    lock.unlock();
    try {
      stage();
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    return failure;
  }

  void start_helper() {
    if (helpers_.size() + 1 >= threads_) return;
    try {
      helpers_.emplace_back([this] { help(); });
    } catch (const std::system_error&) {
      threads_ = 1;  // the system gives no more of them; those there are will do
    }
  }

  Slot& slot(std::size_t item) { return slots_[item % slots_.size()]; }
  const Slot& slot(std::size_t item) const { return slots_[item % slots_.size()]; }

  std::size_t threads_;
  std::vector<Slot> slots_;
  const Stages& stages_;

  std::mutex mutex_;  // of everything below, and of slots_
  std::condition_variable changed_;
  std::size_t read_ = 0, begun_ = 0, written_ = 0;  // so many items
  bool reading_ = false, writing_ = false;          // some thread is at it
  bool ended_ = false;                              // nothing is left to read
  std::exception_ptr failure_;                      // of the item whose turn it was
  std::vector<std::thread> helpers_;
};

void run_one_by_one(const Stages& stages) {
  while (stages.read(0)) {
    stages.work(0);
    stages.write(0);
  }
}

}  // namespace

std::size_t items_in_flight(int threads) {
  const std::size_t count = thread_count(threads);
  return count == 1 ? 1 : 2 * count;
}

void internal::run_slots_in_order(int threads, const Stages& stages) {
  const std::size_t count = thread_count(threads);
  if (count == 1) return run_one_by_one(stages);
  OrderedRun(count, items_in_flight(threads), stages).run();
}

}  // namespace libstyle
