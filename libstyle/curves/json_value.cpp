// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/json_value.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "libstyle/base/error.h"
#include "libstyle/base/number.h"

namespace libstyle::json {
namespace {

std::string to_message(simdjson::error_code code) {
  switch (code) {
    case simdjson::UTF8_ERROR:
      return "not UTF-8 text";
    case simdjson::UNESCAPED_CHARS:
      return "not JSON: a control character inside a string";
    case simdjson::UNCLOSED_STRING:
      return "not JSON: a string is not closed";
    case simdjson::STRING_ERROR:
      return "not JSON: a wrong escape in a string";
    case simdjson::INCOMPLETE_ARRAY_OR_OBJECT:
      return "not JSON: an object or array is not closed";
    case simdjson::NUMBER_ERROR:
      return "not JSON, or a number too large for a double";
    case simdjson::DEPTH_ERROR:
      return "objects and arrays are nested too deeply";
    case simdjson::CAPACITY:
    case simdjson::MEMALLOC:
      return "too much memory would be needed";
    default:
      return "not JSON: a comma, colon, bracket or value is missing or out of place";
  }
}

std::string_view trimmed(std::string_view text) {
  return text.substr(0, text.find_last_not_of(" \t\r") + 1);
}

// A value as it is shown in a message.
std::string excerpt(Value& value) {
  constexpr std::size_t kLongest = 40;
  std::string_view token = trimmed(value.raw_json_token());
  if (token.starts_with('[')) return "an array";
  if (token.starts_with('{')) return "an object";
  if (token.size() <= kLongest) return std::string(token);
  std::size_t cut = kLongest;
  while (cut > 0 && (token[cut] & 0xC0) == 0x80) --cut;  // not inside a character
  return std::string(token.substr(0, cut)) + "...";
}

std::string describe_range(double low, double high) {
  std::string text = "a finite number";
  if (std::isinf(low) && std::isinf(high)) return text;
  text += " from ";
  append_number(text, low);
  if (std::isinf(high)) return text + " up";
  text += " to ";
  append_number(text, high);
  return text;
}

}  // namespace

void check(simdjson::error_code code) {
  if (code != simdjson::SUCCESS) throw Error(to_message(code));
}

void fail_wanted(Value& value, std::string_view wanted) {
  throw Error("must be " + std::string(wanted) + ", not " + excerpt(value));
}

std::string_view read_text(Value& value) {
  const std::string_view token = trimmed(value.raw_json_token());
  if (!token.starts_with('"')) fail_wanted(value, "a string");
  // Nearly every string, path data above all, has no escapes and is read where it stands.
  const bool whole = token.size() >= 2 && token.ends_with('"');
  if (whole && !std::memchr(token.data(), '\\', token.size())) {
    return token.substr(1, token.size() - 2);
  }
  std::string_view text;
  check(value.get_string().get(text));
  return text;
}

bool read_flag(Value& value) {
  bool flag = false;
  if (value.get_bool().get(flag) != simdjson::SUCCESS) fail_wanted(value, "true or false");
  return flag;
}

double read_number(Value& value, double low, double high) {
  double number = 0;
  const bool good = value.get_double().get(number) == simdjson::SUCCESS;
  if (!good || !(number >= low && number <= high)) fail_wanted(value, describe_range(low, high));
  return number;
}

std::vector<double> read_numbers(Value& value, double low) {
  std::vector<double> numbers;
  read_list(value, [&](Value& item) {
    numbers.push_back(read_number(item, low, std::numeric_limits<double>::infinity()));
  });
  return numbers;
}

void read_exactly(Value& value, std::span<double> numbers) {
  const std::vector<double> read = read_numbers(value, -std::numeric_limits<double>::infinity());
  if (read.size() != numbers.size()) {
    throw Error("must have " + std::to_string(numbers.size()) + " numbers, not " +
                std::to_string(read.size()));
  }
  std::ranges::copy(read, numbers.begin());
}

RawChecker::Checked RawChecker::check_text(std::string_view text) {
  Checked checked{text, {}};
  constexpr bool kCopyForPadding = false;
  check(parser_.parse(text.data(), text.size(), kCopyForPadding).get(checked.element));
  return checked;
}

RawChecker::Checked RawChecker::check_value(Value& value) {
  std::string_view text;
  check(simdjson::to_json_string(value).get(text));
  return check_text(text);
}

std::string to_compact(std::string_view json) {
  std::string compact(json.size(), '\0');
  std::size_t length = 0;
  check(simdjson::minify(json.data(), json.size(), compact.data(), length));
  compact.resize(length);
  return compact;
}

}  // namespace libstyle::json
