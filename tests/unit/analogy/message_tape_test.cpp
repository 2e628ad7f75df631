// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/message_tape.h"

#include <gtest/gtest.h>

namespace libstyle {
namespace {

// Message i holds the steps from i to the end, and a checksum that depends on all later steps.
void count_down(std::size_t step, std::span<const double> next, std::span<double> message) {
  message[0] = next.empty() ? 1 : next[0] + 1;
  message[1] = static_cast<double>(step) + (next.empty() ? 0 : next[1] / 2);
}

TEST(MessageTape, GivesEveryMessageInRisingOrder) {
  for (const std::size_t steps : {1u, 2u, 3u, 10u, 99u}) {
    MessageTape tape(steps, 2, count_down);
    for (std::size_t step = 0; step < steps; ++step) {
      EXPECT_EQ(tape.at(step)[0], static_cast<double>(steps - step));
    }
  }
}

TEST(MessageTape, MakesAgainWhatItDidNotKeep) {
  // So many states that only sqrt(steps) messages are kept.
  constexpr std::size_t kStates = std::size_t{1} << 20, kSteps = 10;
  std::size_t made = 0;
  MessageTape tape(kSteps, kStates, [&](std::size_t step, auto next, auto message) {
    ++made;
    count_down(step, next, message);
  });
  double checksum = 0;
  for (std::size_t step = kSteps; step-- > 0;) checksum = static_cast<double>(step) + checksum / 2;
  EXPECT_EQ(tape.at(0)[1], checksum);
  for (std::size_t step = 0; step < kSteps; ++step) {
    EXPECT_EQ(tape.at(step)[0], static_cast<double>(kSteps - step));
  }
  EXPECT_GT(made, kSteps);
  EXPECT_LE(made, 2 * kSteps);
}

}  // namespace
}  // namespace libstyle
