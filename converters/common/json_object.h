// SPDX-License-Identifier: Apache-2.0
// A JSON object, put together key by key on one line: for reports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace libstyle {

class JsonObject {
 public:
  // Texts can be any bytes, such as the names of files; what is not UTF-8 reads as U+FFFD.
  JsonObject& text(std::string_view key, std::string_view value);
  // null if it is empty.
  JsonObject& text_or_null(std::string_view key, std::string_view value);
  JsonObject& flag(std::string_view key, bool value);
  JsonObject& count(std::string_view key, std::uint64_t value);
  // null if it is 0.
  JsonObject& line(std::string_view key, std::size_t value);
  // null if it is unset or not finite.
  JsonObject& number(std::string_view key, std::optional<double> value);
  JsonObject& object(std::string_view key, const JsonObject& value);
  JsonObject& list(std::string_view key, std::span<const JsonObject> values);

  std::string to_json() const { return '{' + members_ + '}'; }

 private:
  std::string& begin(std::string_view key);

  std::string members_;
};

// Appends a text in quotes, whatever its bytes.
void append_any_text(std::string& json, std::string_view text);

}  // namespace libstyle
