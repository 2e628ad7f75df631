// SPDX-License-Identifier: Apache-2.0
// The messages of a dynamic programme, made from the last step to the first and read from the first
// to the last, in memory for about 2 sqrt(steps) of them instead of all.
//
// Every k-th message is kept; the k before it are made again when the reader comes to them. That
// costs each message twice and lets one long curve of a drawing pass in a few megabytes.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace libstyle {

class MessageTape {
 public:
  // Makes `message` for `step` from the message of step + 1; `next` is empty at the last step.
  using Maker = std::function<void(std::size_t step, std::span<const double> next,
                                   std::span<double> message)>;

  // `steps` and `states` are at least 1.
  MessageTape(std::size_t steps, std::size_t states, Maker make);

  // The message of `step`. Steps are asked for in rising order; the span lasts until the next call.
  std::span<const double> at(std::size_t step);

 private:
  std::span<double> slot(std::vector<double>& messages, std::size_t index) {
    return std::span(messages).subspan(index * states_, states_);
  }
  void fill_block(std::size_t block);

  std::size_t steps_;
  std::size_t states_;
  std::size_t block_size_;
  Maker make_;
  std::vector<double> heads_;  // the first message of every block
  std::vector<double> block_;  // all messages of block_index_
  std::size_t block_index_;
};

}  // namespace libstyle
