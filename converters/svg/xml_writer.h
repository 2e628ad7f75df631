// SPDX-License-Identifier: Apache-2.0
// Writes XML that a person can read: one element a line, indented as it nests.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "libstyle/base/bytes.h"

namespace libstyle::svg {

class XmlWriter {
 public:
  // The sink outlives the writer.
  explicit XmlWriter(ByteSink& sink) : sink_(sink) {}

  // Elements; names live until finish(). Attributes follow begin() at once.
  void begin(std::string_view element);
  void end();

  // Characters that XML cannot hold become U+FFFD.
  void attribute(std::string_view name, std::string_view value);
  void attribute(std::string_view name, double value);

  // Character data on lines of its own.
  void text(std::string_view text);

  // Everything has been ended; the sink has it all.
  void finish();

 private:
  void begin_line();
  void close_tag();
  void flush_if_large();

  ByteSink& sink_;
  std::string text_;
  std::vector<std::string_view> open_;
  bool tag_is_open_ = false;  // attributes can still follow
};

}  // namespace libstyle::svg
