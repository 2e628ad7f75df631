// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/ordered_work.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "tests/support/seeds.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A stage that takes its time, a different one for each item and run.
void dawdle(std::uint64_t seed, int item) {
  const RandomStream random(seed, 7);
  std::this_thread::sleep_for(
      std::chrono::microseconds(random.below(static_cast<std::uint64_t>(item), 200)));
}

std::vector<int> counted(int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

// A stream of 0, 1, 2 ... whose squares are written.
struct Squares {
  int count = 0;
  int threads = 0;
  std::function<void(const std::string& stage, int number)> before = [](const std::string&, int) {};

  std::vector<int> written = {};  // the numbers
  std::set<std::thread::id> used_threads = {};

  struct Item {
    int number = -1;
    int square = 0;
  };

  void run() {
    int next = 0;
    run_in_order<Item>(threads, {.read =
                                     [&](Item& item) {
                                       note_thread();
                                       EXPECT_EQ(item.number, -1) << "an item is new";
                                       if (next == count) return false;
                                       item.number = next++;
                                       before("read", item.number);
                                       return true;
                                     },
                                 .work =
                                     [&](Item& item) {
                                       note_thread();
                                       before("work", item.number);
                                       item.square = item.number * item.number;
                                     },
                                 .write =
                                     [&](Item& item) {
                                       note_thread();
                                       before("write", item.number);
                                       EXPECT_EQ(item.square, item.number * item.number);
                                       written.push_back(item.number);
                                     }});
  }

 private:
  void note_thread() {
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    used_threads.insert(std::this_thread::get_id());
  }
};

TEST(OrderedWork, WritesInTheOrderOfReadingOnAnyNumberOfThreads) {
  for_each_seed(20, [](std::uint64_t seed) {
    for (const int threads : {0, 1, 2, 3, 8, 1000000}) {
      for (const int count : {0, 1, 2, 3, 40}) {
        Squares squares{count, threads,
                        [&](const std::string&, int number) { dawdle(seed, number); }};
        squares.run();
        EXPECT_EQ(squares.written, counted(count)) << threads << " threads";
      }
    }
  });
}

TEST(OrderedWork, HoldsTwoItemsAThreadWhenOneIsSlow) {
  for (const int threads : {1, 2, 5}) {
    std::atomic<int> held = 0;
    int most = 0;
    Squares squares{60, threads, [&](const std::string& stage, int number) {
                      if (stage == "read") most = std::max(most, ++held);
                      if (stage == "work" && number % 20 == 0) {
                        std::this_thread::sleep_for(std::chrono::milliseconds(10));
                      }
                      if (stage == "write") --held;
                    }};
    squares.run();
    EXPECT_LE(most, static_cast<int>(items_in_flight(threads)));
    EXPECT_EQ(squares.written, counted(60));
  }
  EXPECT_EQ(items_in_flight(1), 1u);
  EXPECT_EQ(items_in_flight(5), 10u);
}

// Each waits for all the others, so it ends only if as many threads as were asked for work.
TEST(OrderedWork, WorksOnAsManyThreadsAsAskedFor) {
  constexpr int kThreads = 4;
  std::mutex mutex;
  std::condition_variable changed;
  int working = 0;
  Squares squares{kThreads, kThreads, [&](const std::string& stage, int) {
                    if (stage != "work") return;
                    std::unique_lock lock(mutex);
                    ++working;
                    changed.notify_all();
                    EXPECT_TRUE(changed.wait_for(lock, std::chrono::seconds(60),
                                                 [&] { return working == kThreads; }));
                  }};
  squares.run();
  EXPECT_EQ(squares.used_threads.size(), static_cast<std::size_t>(kThreads));
}

TEST(OrderedWork, AStreamOfOneStaysOnTheThreadOfTheCaller) {
  Squares squares{1, 8, [](const std::string&, int) {
                    std::this_thread::sleep_for(std::chrono::milliseconds(5));
                  }};
  squares.run();
  EXPECT_THAT(squares.used_threads, ElementsAre(std::this_thread::get_id()));
}

TEST(OrderedWork, OneThreadTakesOneItemAfterTheOther) {
  std::vector<std::string> calls;
  Squares squares{
      2, 1, [&](const std::string& stage, int i) { calls.push_back(stage + std::to_string(i)); }};
  squares.run();
  EXPECT_THAT(calls, ElementsAre("read0", "work0", "write0", "read1", "work1", "write1"));
}

class Failure : public std::runtime_error {
 public:
  explicit Failure(int item) : std::runtime_error("failure"), number(item) {}
  int number;
};

// The number of the item whose failure ended the run.
int failure_of(Squares& squares) {
  try {
    squares.run();
  } catch (const Failure& failure) {
    return failure.number;
  }
  return -1;
}

TEST(OrderedWork, TheFirstFailureWinsAndAllBeforeItIsWritten) {
  for_each_seed(20, [](std::uint64_t seed) {
    RandomValues random(seed);
    const int first = static_cast<int>(random.below(30));
    for (const std::string stage : {"read", "work", "write"}) {
      for (const int threads : {1, 2, 6}) {
        Squares squares{40, threads, [&](const std::string& at, int number) {
                          dawdle(seed, number);
                          // Those behind the first fail too, and sooner.
                          if (number >= first && at == stage) throw Failure(number);
                        }};
        EXPECT_EQ(failure_of(squares), first) << stage << ", " << threads << " threads";
        EXPECT_EQ(squares.written, counted(first)) << stage << ", " << threads << " threads";
      }
    }
  });
}

TEST(OrderedWork, AFailureOfTheFirstWritesNothing) {
  Squares squares{5, 3, [](const std::string& stage, int number) {
                    if (stage == "work" && number == 0) throw Failure(number);
                  }};
  EXPECT_EQ(failure_of(squares), 0);
  EXPECT_THAT(squares.written, IsEmpty());
}

}  // namespace
}  // namespace libstyle
