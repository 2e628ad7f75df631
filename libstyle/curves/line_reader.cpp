// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/line_reader.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "libstyle/base/error.h"

namespace libstyle {
namespace {

constexpr std::size_t kFirstBuffer = std::size_t{256} << 10;

}  // namespace

bool LineReader::next(Line& line) {
  ++number_;
  scanned_ = begin_;
  const char* newline = nullptr;
  for (;;) {
    const std::size_t unscanned = end_ - scanned_;
    if (unscanned > 0) {
      newline = static_cast<const char*>(std::memchr(&buffer_[scanned_], '\n', unscanned));
    }
    if (newline) break;
    scanned_ = end_;
    if (end_ - begin_ > limit_) break;
    if (!fill()) break;
  }
  const auto stop = newline ? static_cast<std::size_t>(newline - buffer_.data()) : end_;
  if (stop - begin_ > limit_) {
    throw Error("the line is longer than " + std::to_string(limit_) +
                " bytes; divide the record into several");
  }
  if (!newline && stop == begin_) return false;
  line.text = {buffer_.data() + begin_, stop - begin_};
  if (line.text.ends_with('\r')) line.text.remove_suffix(1);
  line.number = number_;
  line.ended = newline != nullptr;
  begin_ = newline ? stop + 1 : stop;
  return true;
}

// Reads more of the source; false at its end.
bool LineReader::fill() {
  make_room();
  const std::size_t count = source_.read({buffer_.data() + end_, buffer_.size() - kPadding - end_});
  end_ += count;
  return count > 0;
}

// Moves the unfinished line to the front and doubles the buffer where that is not enough.
void LineReader::make_room() {
  if (buffer_.empty()) buffer_.resize(kFirstBuffer + kPadding);
  const std::size_t capacity = buffer_.size() - kPadding;
  if (end_ < capacity && begin_ == 0) return;
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  scanned_ -= begin_;
  begin_ = 0;
  if (end_ == capacity) buffer_.resize(2 * capacity + kPadding);
}

}  // namespace libstyle
