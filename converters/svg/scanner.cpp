// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/scanner.h"

#include <algorithm>

#include "libstyle/base/number.h"

namespace libstyle::svg {
std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, to_lower, to_lower);
}

bool Scanner::skip_separator() {
  skip_spaces();
  if (!take(',')) return false;
  skip_spaces();
  return true;
}

bool Scanner::take(char c) {
  if (next_ == end_ || *next_ != c) return false;
  ++next_;
  return true;
}

bool Scanner::take_number(double& value) {
  std::string_view rest(next_, end_);
  if (rest.starts_with('+')) {
    rest.remove_prefix(1);
    if (rest.starts_with('-')) return false;
  }
  if (!libstyle::take_number(rest, value)) return false;
  next_ = end_ - rest.size();
  return true;
}

bool Scanner::take_css_number(double& value) {
  const char* const before = next_;
  if (!take_number(value)) return false;
  const std::string_view taken(before, next_);
  const std::size_t point = taken.find('.');
  if (point == taken.npos || (point + 1 < taken.size() && is_digit(taken[point + 1]))) return true;
  next_ = before + point;
  return Scanner(taken.substr(0, point)).take_number(value);
}

std::string_view Scanner::take_word() {
  const char* first = next_;
  if (first != end_ && is_digit(*first)) return {};
  const auto is_word = [](char c) {
    return is_digit(c) || c == '-' || c == '_' || (to_lower(c) >= 'a' && to_lower(c) <= 'z');
  };
  while (next_ != end_ && is_word(*next_)) ++next_;
  return {first, next_};
}

NumberList parse_number_list(std::string_view text) {
  NumberList list;
  Scanner scanner(text);
  scanner.skip_spaces();
  bool comma = false;
  double number = 0;
  while (scanner.take_number(number)) {
    list.numbers.push_back(number);
    comma = scanner.skip_separator();
  }
  list.complete = scanner.at_end() && !comma;
  return list;
}

}  // namespace libstyle::svg
