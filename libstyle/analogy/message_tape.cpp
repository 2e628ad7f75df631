// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/message_tape.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace libstyle {
namespace {

// Up to this many numbers nothing is thrown away: 16 MB for each thread.
constexpr std::size_t kKept = std::size_t{1} << 21;

std::size_t choose_block_size(std::size_t steps, std::size_t states) {
  const auto root = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(steps))));
  return std::min(steps, std::max(root, kKept / states));
}

}  // namespace

MessageTape::MessageTape(std::size_t steps, std::size_t states, Maker make)
    : steps_(steps),
      states_(states),
      block_size_(choose_block_size(steps, states)),
      make_(std::move(make)) {
  assert(steps > 0 && states > 0);
  const std::size_t blocks = (steps + block_size_ - 1) / block_size_;
  heads_.resize(blocks * states_);
  block_.resize(block_size_ * states_);
  for (std::size_t block = blocks; block-- > 0;) {
    fill_block(block);
    std::ranges::copy(slot(block_, 0), slot(heads_, block).begin());
  }
}

std::span<const double> MessageTape::at(std::size_t step) {
  assert(step < steps_);
  const std::size_t block = step / block_size_;
  if (block != block_index_) fill_block(block);
  return slot(block_, step - block * block_size_);
}

void MessageTape::fill_block(std::size_t block) {
  const std::size_t first = block * block_size_;
  const std::size_t end = std::min(first + block_size_, steps_);
  std::span<const double> next;
  if (end < steps_) next = slot(heads_, block + 1);
  for (std::size_t step = end; step-- > first;) {
    const std::span<double> message = slot(block_, step - first);
    make_(step, next, message);
    next = message;
  }
  block_index_ = block;
}

}  // namespace libstyle
