// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/path_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <string>

#include "libstyle/base/error.h"
#include "libstyle/base/random.h"

namespace libstyle {
namespace {

using ::testing::HasSubstr;

// Any double at all but NaN and infinity.
double any_coordinate(const RandomStream& stream, std::uint64_t& next) {
  for (;;) {
    const double value = std::bit_cast<double>(stream.bits(next++));
    if (std::isfinite(value)) return value;
  }
}

Path any_path(std::uint64_t seed) {
  const RandomStream stream(seed, 0);
  std::uint64_t next = 0;
  const auto point = [&] {
    const double x = any_coordinate(stream, next);
    return Point{x, any_coordinate(stream, next)};
  };
  Path path;
  bool open = false;
  for (std::uint64_t left = stream.below(next++, 30); left > 0; --left) {
    const std::uint64_t command = open ? stream.below(next++, 4) : 0;
    if (command == 0) path.move_to(point());
    if (command == 1) path.line_to(point());
    if (command == 2) {
      const Point first = point(), second = point();
      path.cubic_to(first, second, point());
    }
    if (command == 3) path.close();
    open = command != 3;
  }
  return path;
}

std::string failure(std::string_view text) {
  try {
    parse_path_data(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(PathData, ReadsBackBitForBit) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const Path path = any_path(seed);
    ASSERT_EQ(parse_path_data(to_path_data(path)), path) << to_path_data(path);
  }
}

TEST(PathData, IsWrittenWithALetterForEveryCommand) {
  const Path path = parse_path_data("M0,0 10,0 20 0 C10 5 5 10 0 10 -1-1-2-2-3-3ZM.5.5");
  EXPECT_EQ(to_path_data(path), "M0 0 L10 0 L20 0 C10 5 5 10 0 10 C-1 -1 -2 -2 -3 -3 Z M0.5 0.5");
}

TEST(PathData, OfNothingIsTheEmptyPath) {
  EXPECT_TRUE(parse_path_data("").empty());
  EXPECT_TRUE(parse_path_data(" \t\r\n").empty());
  EXPECT_EQ(to_path_data(Path()), "");
}

TEST(PathData, HoldsTheLargestCoordinates) {
  const Path path = parse_path_data("M1e308 -1e308L1.7976931348623157e308 5e-324");
  EXPECT_EQ(path.points()[0], (Point{1e308, -1e308}));
  EXPECT_EQ(to_path_data(path), "M1e+308 -1e+308 L1.7976931348623157e+308 5e-324");
}

TEST(PathData, FailsSayingWhereAndWhy) {
  EXPECT_THAT(failure("M0 0 l1 1"), HasSubstr("character 6: \"l\" is not one of"));
  EXPECT_THAT(failure("M0 0 \xff"), HasSubstr("character 6: \"\\255\" is not one of"));
  EXPECT_THAT(failure("L0 0"), HasSubstr("a subpath must begin with M"));
  EXPECT_THAT(failure("Z"), HasSubstr("a subpath must begin with M"));
  EXPECT_THAT(failure("M0 0 Z L1 1"), HasSubstr("a subpath must begin with M"));
  EXPECT_THAT(failure("M0 0 Z 1 1"), HasSubstr("character 8: \"1\" is not one of"));
  EXPECT_THAT(failure("M0"), HasSubstr("character 3: a number is missing"));
  EXPECT_THAT(failure("M0 0,"), HasSubstr("character 6: a number is missing"));
  EXPECT_THAT(failure("M0 0 L1,,1"), HasSubstr("character 9: a number is missing"));
  EXPECT_THAT(failure("M,0 0"), HasSubstr("character 2: a number is missing"));
  EXPECT_THAT(failure("M0 0 C1 1 2 2 3"), HasSubstr("a number is missing"));
  EXPECT_THAT(failure("M0 0 L1 nan"), HasSubstr("character 9: a number is missing or too large"));
  EXPECT_THAT(failure("M0 0 L1e999 1"), HasSubstr("character 7: a number is missing or too large"));
}

}  // namespace
}  // namespace libstyle
