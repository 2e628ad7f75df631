// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/scanner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace libstyle::svg {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Scanner, LeavesTheTextAloneWhenThereIsNoNumber) {
  for (const char* text : {"", "+", "-", ".", "+-1", "-+1", "e5", "inf", "nan", "0x", "1e999"}) {
    Scanner scanner(text);
    double value = 0;
    if (scanner.take_number(value)) {
      EXPECT_EQ(std::string_view(text), "0x");  // a zero, then an x
      EXPECT_EQ(scanner.position(), 1u);
    } else {
      EXPECT_EQ(scanner.position(), 0u) << text;
    }
  }
}

TEST(Scanner, TakesANumberTooSmallForADoubleAsZero) {
  Scanner scanner("1e-999");
  double value = 1;
  EXPECT_TRUE(scanner.take_number(value));
  EXPECT_EQ(value, 0);
  EXPECT_TRUE(scanner.at_end());
}

TEST(Scanner, SkipsOneCommaOnly) {
  Scanner scanner(" , ,x");
  EXPECT_TRUE(scanner.skip_separator());
  EXPECT_TRUE(scanner.skip_separator());
  EXPECT_FALSE(scanner.skip_separator());
  EXPECT_EQ(scanner.peek(), 'x');
}

TEST(NumberList, TakesSpacesOrOneCommaBetween) {
  const NumberList list = parse_number_list(" 1 2,3 , 4-5.5.5 ");
  EXPECT_THAT(list.numbers, ElementsAre(1, 2, 3, 4, -5.5, .5));
  EXPECT_TRUE(list.complete);
}

TEST(NumberList, ReadsUpToTheFirstError) {
  EXPECT_THAT(parse_number_list("1 2 x 3").numbers, ElementsAre(1, 2));
  EXPECT_FALSE(parse_number_list("1 2 x 3").complete);
  EXPECT_FALSE(parse_number_list("1,,2").complete);
  EXPECT_FALSE(parse_number_list("1,").complete);
  EXPECT_THAT(parse_number_list("").numbers, IsEmpty());
  EXPECT_TRUE(parse_number_list("").complete);
}

}  // namespace
}  // namespace libstyle::svg
