// SPDX-License-Identifier: Apache-2.0
// Splits a source into lines, holding one line and one buffer of input at a time. Internal to
// libstyle/curves.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "libstyle/base/bytes.h"

namespace libstyle {

struct Line {
  // Without its end ("\n" or "\r\n"). Valid until the next line is read; kPadding bytes after it
  // may be read too.
  std::string_view text;
  std::size_t number = 0;  // from 1
  bool ended = true;       // false for a last line without newline
};

class LineReader {
 public:
  static constexpr std::size_t kPadding = 64;

  // Lines may be up to `limit` bytes long.
  LineReader(ByteSource& source, std::size_t limit) : source_(source), limit_(limit) {}

  // Returns false at the end of the source. Throws Error (no place) for a line over the limit.
  bool next(Line& line);

  // The number of the line read last, or being read when next() threw.
  std::size_t line_number() const { return number_; }

 private:
  bool fill();
  void make_room();

  ByteSource& source_;
  std::size_t limit_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;    // of what has not been handed out
  std::size_t scanned_ = 0;  // no newline between begin_ and here
  std::size_t end_ = 0;      // of what has been read
  std::size_t number_ = 0;
};

}  // namespace libstyle
