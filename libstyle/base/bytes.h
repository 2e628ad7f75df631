// SPDX-License-Identifier: Apache-2.0
// Where bytes come from and go to. The library knows these two interfaces and no files.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace libstyle {

class ByteSource {
 public:
  virtual ~ByteSource() = default;

  // Fills the front of `buffer` and returns how many bytes that was; 0 only at the end.
  // Throws Error when reading fails.
  virtual std::size_t read(std::span<char> buffer) = 0;
};

class ByteSink {
 public:
  virtual ~ByteSink() = default;

  // Takes all of `bytes`. Throws Error when writing fails.
  virtual void write(std::string_view bytes) = 0;
};

// A source over text that outlives it.
class TextSource final : public ByteSource {
 public:
  explicit TextSource(std::string_view text) : rest_(text) {}
  std::size_t read(std::span<char> buffer) override;

 private:
  std::string_view rest_;
};

// A sink that gathers everything in `text`.
class TextSink final : public ByteSink {
 public:
  void write(std::string_view bytes) override { text.append(bytes); }

  std::string text;
};

}  // namespace libstyle
