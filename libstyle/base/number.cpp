// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/number.h"

#include <fmt/compile.h>

#include <algorithm>
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

// Digits without an exponent whose value is m / 10^k with both parts exact: the one division rounds
// correctly, so this agrees with from_chars (Clinger, "How to read floating point numbers
// accurately", PLDI 1990). Returns the end of the number, or null when it is of another kind.
const char* take_short_decimal(const char* begin, const char* end, double& value) {
  const char* at = begin;
  const bool negative = at != end && *at == '-';
  if (negative) ++at;
  const char* const digits = at;
  std::uint64_t mantissa = 0;
  for (; at != end && is_digit(*at); ++at) mantissa = mantissa * 10 + std::uint64_t(*at - '0');
  std::ptrdiff_t digit_count = at - digits, fraction_count = 0;
  if (at != end && *at == '.') {
    const char* const fraction = ++at;
    for (; at != end && is_digit(*at); ++at) mantissa = mantissa * 10 + std::uint64_t(*at - '0');
    fraction_count = at - fraction;
    digit_count += fraction_count;
  }
  if (at != end && (*at == 'e' || *at == 'E')) return nullptr;
  // 19 digits fit into 64 bits, so the comparison is with the true mantissa.
  if (digit_count == 0 || digit_count > 19 || mantissa > kExactIntegers) return nullptr;
  const double magnitude = static_cast<double>(mantissa) / kPowersOfTen[fraction_count];
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

}  // namespace

void append_number(std::string& text, double value) {
  assert(std::isfinite(value));
  char buffer[32];
  char* end = fmt::format_to(buffer, FMT_COMPILE("{}"), value + 0.0);  // + 0.0 drops the sign of -0
  text.append(buffer, end);
}

bool take_number(std::string_view& text, double& value) {
  const char* const begin = text.data();
  const char* end = take_short_decimal(begin, begin + text.size(), value);
  if (!end) {
    double read = 0;
    const auto [rest, fault] = std::from_chars(begin, begin + text.size(), read);
    const auto length = static_cast<std::size_t>(rest - begin);
    if (fault == std::errc::result_out_of_range) {
      if (!is_tiny(text.substr(0, length))) return false;
      read = 0;
    } else if (fault != std::errc() || !std::isfinite(read)) {
      return false;
    }
    value = read;
    end = rest;
  }
  text.remove_prefix(static_cast<std::size_t>(end - begin));
  return true;
}

}  // namespace libstyle
