// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/number.h"

#include <fmt/compile.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace libstyle {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Every power of ten that a double holds exactly.
constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t kExactIntegers = std::uint64_t{1} << 53;

const char* take_digits(const char* at, const char* end, std::uint64_t& digits) {
  for (; at != end && is_digit(*at); ++at) digits = digits * 10 + std::uint64_t(*at - '0');
  return at;
}

// Digits without an exponent whose value is m / 10^k with both parts exact: the one division rounds
// correctly, so this agrees with from_chars (Clinger, "How to read floating point numbers
// accurately", PLDI 1990). Returns the end of the number, or null when it is of another kind.
const char* parse_short_decimal(const char* begin, const char* end, double& value) {
  const bool negative = begin != end && *begin == '-';
  const char* const integer = begin + negative;
  std::uint64_t mantissa = 0;
  const char* at = take_digits(integer, end, mantissa);
  std::ptrdiff_t digits = at - integer, places = 0;
  if (at != end && *at == '.') {
    const char* const fraction = at + 1;
    at = take_digits(fraction, end, mantissa);
    places = at - fraction;
    digits += places;
  }
  if (at != end && (*at == 'e' || *at == 'E')) return nullptr;
  // 19 digits fit into 64 bits, so the comparison is with the true mantissa.
  if (digits == 0 || digits > 19 || mantissa > kExactIntegers) return nullptr;
  const double magnitude = static_cast<double>(mantissa) / kPowersOfTen[places];
  value = negative ? -magnitude : magnitude;
  return at;
}

// Whether a number that no double holds is too small rather than too large: the sign of the decimal
// exponent of its first digit that is not zero.
bool is_tiny(std::string_view text) {
  const std::size_t mantissa_end = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, mantissa_end);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  const auto leading = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  if (mantissa_end == text.size()) return leading < 0;
  std::string_view exponent_text = text.substr(mantissa_end + 1);
  if (exponent_text.starts_with('+')) exponent_text.remove_prefix(1);
  std::int64_t exponent = 0;
  const auto fault =
      std::from_chars(exponent_text.data(), exponent_text.data() + exponent_text.size(), exponent)
          .ec;
  if (fault != std::errc()) return exponent_text.starts_with('-');
  return leading + exponent < 0;
}

constexpr std::array<char, 200> kDigitPairs = [] {
  std::array<char, 200> pairs{};
  for (int i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}();

void put_pair(char* at, std::uint32_t pair) { std::copy_n(&kDigitPairs[2 * pair], 2, at); }

// Writes so that the last digit stands before `end`; returns the first.
char* put_integer_before(char* end, std::uint32_t integer) {
  for (; integer >= 100; integer /= 100) put_pair(end -= 2, integer % 100);
  if (integer >= 10) {
    put_pair(end -= 2, integer);
  } else {
    *--end = static_cast<char>('0' + integer);
  }
  return end;
}

// Writes six decimal places after the point at `at` but for the zeros at their end; returns the
// end.
char* put_fraction(char* at, std::uint32_t millionths) {
  if (millionths == 0) return at;
  *at++ = '.';
  put_pair(at, millionths / 10000);
  put_pair(at + 2, millionths / 100 % 100);
  put_pair(at + 4, millionths % 100);
  char* end = at + 6;
  while (end[-1] == '0') --end;
  return end;
}

// Values with up to six decimal places and 15 digits in all. Where the decimal n / 10^6 is nearest
// to no other double than `value`, and that is what the exact division tests, no other decimal of
// up to 15 digits is either: so this is the shortest one. Returns false for all other values.
bool append_short_decimal(std::string& text, double value) {
  const double magnitude = std::abs(value);
  if (magnitude != 0 && !(magnitude >= 1e-4 && magnitude < 1e9)) return false;
  const auto millionths = static_cast<std::uint64_t>(magnitude * 1e6 + 0.5);
  if (static_cast<double>(millionths) / 1e6 != magnitude) return false;
  char buffer[24];
  char* const point = buffer + 12;
  const auto integer = static_cast<std::uint32_t>(millionths / 1000000);
  char* begin = put_integer_before(point, integer);
  if (value < 0) *--begin = '-';
  text.append(begin, put_fraction(point, static_cast<std::uint32_t>(millionths % 1000000)));
  return true;
}

}  // namespace

void append_number(std::string& text, double value) {
  assert(std::isfinite(value));
  if (append_short_decimal(text, value)) return;
  char buffer[32];
  char* end = fmt::format_to(buffer, FMT_COMPILE("{}"), value);
  text.append(buffer, end);
}

const char* parse_number(const char* begin, const char* end, double& value) {
  if (const char* const rest = parse_short_decimal(begin, end, value)) return rest;
  double read = 0;
  const auto [rest, fault] = std::from_chars(begin, end, read);
  if (fault == std::errc::result_out_of_range) {
    if (!is_tiny({begin, rest})) return nullptr;
    read = 0;
  } else if (fault != std::errc() || !std::isfinite(read)) {
    return nullptr;
  }
  value = read;
  return rest;
}

bool take_number(std::string_view& text, double& value) {
  const char* const rest = parse_number(text.data(), text.data() + text.size(), value);
  if (!rest) return false;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  return true;
}

}  // namespace libstyle
