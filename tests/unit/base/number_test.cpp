// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "libstyle/base/random.h"

namespace libstyle {
namespace {

std::string written(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

double read_whole(std::string_view text) {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string_view rest = text;
  EXPECT_TRUE(take_number(rest, value)) << text;
  EXPECT_EQ(rest, "") << text;
  return value;
}

// What the standard library makes of the same text.
double reference(std::string_view text) {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

TEST(Number, IsWrittenAsTheShortestTextThatReadsBack) {
  EXPECT_EQ(written(0.1), "0.1");
  EXPECT_EQ(written(-3), "-3");
  EXPECT_EQ(written(1e20), "1e+20");
  EXPECT_EQ(written(-0.0), "0");
  EXPECT_EQ(written(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(written(123456.789), "123456.789");
  EXPECT_EQ(written(5e-324), "5e-324");
  EXPECT_EQ(written(0.0001), "0.0001");
  EXPECT_EQ(written(0.00005), "5e-05");
  EXPECT_EQ(written(999999999.5), "999999999.5");
  EXPECT_EQ(written(std::numeric_limits<double>::max()), "1.7976931348623157e+308");
}

TEST(Number, AnyFiniteDoubleReadsBackBitForBit) {
  const RandomStream stream(11, 0);
  for (std::uint64_t i = 0; i < 200000; ++i) {
    const double value = std::bit_cast<double>(stream.bits(i));
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(read_whole(written(value)), value) << written(value);
  }
}

// Both ways, for decimals of every length with up to 12 places.
TEST(Number, ShortDecimalsAgreeWithTheStandardLibrary) {
  const RandomStream stream(12, 0);
  for (std::uint64_t i = 0; i < 200000; ++i) {
    const std::uint64_t limit = std::uint64_t{1} << stream.below(3 * i, 64);
    std::string text = std::to_string(stream.below(3 * i + 1, limit));
    const std::size_t places = stream.below(3 * i + 2, 13);
    if (places > 0 && places < text.size()) text.insert(text.size() - places, ".");
    if (i % 2 == 1) text.insert(0, "-");
    const double value = read_whole(text);
    ASSERT_EQ(value, reference(text)) << text;
    if (std::abs(value) < 1e-4 || std::abs(value) >= 1e16) continue;  // those have exponents
    char shortest[32];
    const auto end =
        std::to_chars(shortest, shortest + sizeof shortest, value, std::chars_format::fixed).ptr;
    ASSERT_EQ(written(value), std::string(shortest, end)) << text;
  }
}

TEST(Number, MayHaveMoreDigitsThanAWordHolds) {
  EXPECT_EQ(read_whole("18446744073709551616"), 18446744073709551616.0);  // 2^64
  EXPECT_EQ(read_whole("0.18446744073709551617"), 0.18446744073709551617);
  EXPECT_EQ(read_whole("9007199254740993"), 9007199254740992.0);  // 2^53 + 1, to even
}

TEST(Number, IsReadAsFarAsItGoes) {
  std::string_view text = "-12.5e1,7";
  double value = 0;
  ASSERT_TRUE(take_number(text, value));
  EXPECT_EQ(value, -125);
  EXPECT_EQ(text, ",7");
  text = "1.5.5";
  ASSERT_TRUE(take_number(text, value));
  EXPECT_EQ(value, 1.5);
  EXPECT_EQ(text, ".5");
  text = "3e";  // an exponent without digits is none
  ASSERT_TRUE(take_number(text, value));
  EXPECT_EQ(value, 3);
  EXPECT_EQ(text, "e");
}

TEST(Number, MayLeaveOutTheDigitsOnOneSideOfThePoint) {
  EXPECT_EQ(read_whole(".5"), 0.5);
  EXPECT_EQ(read_whole("-.5"), -0.5);
  EXPECT_EQ(read_whole("5."), 5);
}

TEST(Number, TooSmallForADoubleIsZero) {
  const std::string many_zeros(400, '0');
  for (const std::string& text : {std::string("1e-400"), std::string("-1e-99999999999999999999"),
                                  "0." + many_zeros + "1", "0." + many_zeros + "1e5"}) {
    EXPECT_EQ(read_whole(text), 0) << text;
  }
}

TEST(Number, RefusesWhatIsNoFiniteNumberAndLeavesTheTextAlone) {
  const std::string many_zeros(400, '0');
  for (const std::string& bad :
       {std::string(""), std::string("."), std::string("-"), std::string("+1"), std::string("e5"),
        std::string("nan"), std::string("inf"), std::string("-infinity"), std::string("1e999"),
        std::string("-1e99999999999999999999"), "1" + many_zeros, "1" + many_zeros + "e-5",
        "0.001e" + std::string("999")}) {
    std::string_view text = bad;
    double value = 42;
    EXPECT_FALSE(take_number(text, value)) << bad;
    EXPECT_EQ(text, bad);
    EXPECT_EQ(value, 42) << bad;
  }
}

}  // namespace
}  // namespace libstyle
