// SPDX-License-Identifier: Apache-2.0
// Reads single JSON values through simdjson and says what is wrong with them. Internal to
// libstyle/curves; simdjson is a heavy header, so only the reader includes this.
//
// simdjson's On Demand parser goes over the text once and checks what it is asked for, no more.
// Known keys are asked for value by value; everything unknown goes through RawChecker.
#pragma once

#include <simdjson.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace libstyle::json {

namespace ondemand = simdjson::ondemand;
using Value = ondemand::value;

// Throws Error (no place) unless `code` is success.
void check(simdjson::error_code code);

// Throws Error: "must be a number, not ...".
[[noreturn]] void fail_wanted(Value& value, std::string_view wanted);

// The text of a string; valid until the parser's next document.
std::string_view read_text(Value& value);

bool read_flag(Value& value);

// A finite number from `low` to `high`; either may be infinite.
double read_number(Value& value, double low, double high);

// Calls read_item(element) for each element of an array.
template <typename ReadItem>
void read_list(Value& value, ReadItem read_item) {
  ondemand::array array;
  if (value.get_array().get(array) != simdjson::SUCCESS) fail_wanted(value, "an array");
  for (auto element : array) {
    Value item;
    check(element.get(item));
    read_item(item);
  }
}

std::vector<double> read_numbers(Value& value, double low);

// Exactly `numbers.size()` finite numbers.
void read_exactly(Value& value, std::span<double> numbers);

// Checks what has no known meaning as a whole.
class RawChecker {
 public:
  struct Checked {
    std::string_view text;
    simdjson::dom::element element;  // valid until the next check
  };

  // Throws Error unless `text` is one JSON value. simdjson's padding must follow it.
  Checked check_text(std::string_view text);
  Checked check_value(Value& value);

 private:
  simdjson::dom::parser parser_;
};

// JSON text without white space between its tokens.
std::string to_compact(std::string_view json);

}  // namespace libstyle::json
