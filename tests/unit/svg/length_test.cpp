// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/length.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace libstyle::svg {
namespace {

using ::testing::ElementsAre;

double px(std::string_view text, LengthAxis axis = LengthAxis::kHorizontal) {
  return resolve(parse_length(text).value(), axis, {300, 400, 20});
}

TEST(Length, AnInchIs96Px) {
  EXPECT_EQ(px("1in"), 96);
  EXPECT_DOUBLE_EQ(px("2.54cm"), 96);
  EXPECT_DOUBLE_EQ(px("25.4mm"), 96);
  EXPECT_DOUBLE_EQ(px("72pt"), 96);
  EXPECT_DOUBLE_EQ(px("6pc"), 96);
  EXPECT_EQ(px("96px"), 96);
  EXPECT_EQ(px("96"), 96);
}

TEST(Length, FollowsTheFontSize) {
  EXPECT_EQ(px("2em"), 40);
  EXPECT_EQ(px("2ex"), 20);
}

TEST(Length, PercentagesFollowTheViewport) {
  EXPECT_EQ(px("50%"), 150);
  EXPECT_EQ(px("50%", LengthAxis::kVertical), 200);
  EXPECT_DOUBLE_EQ(px("100%", LengthAxis::kDiagonal) * px("100%", LengthAxis::kDiagonal),
                   (300 * 300 + 400 * 400) / 2);
}

TEST(Length, TellsAnExponentFromAUnit) {
  EXPECT_EQ(px("1e2"), 100);
  EXPECT_EQ(px("1em"), 20);
  EXPECT_EQ(px("1e1ex"), 100);
}

TEST(Length, TakesUnitsInAnyCaseAndSpaceAround) {
  EXPECT_EQ(parse_length(" +5PX\n"), (Length{5, LengthUnit::kPx}));
  EXPECT_EQ(parse_length("-.5Mm"), (Length{-0.5, LengthUnit::kMm}));
}

TEST(Length, RefusesAnythingElse) {
  for (const char* text : {"", "px", "5 px", "5px 6px", "5parsec", "1e999", "nan", "inf", "--5",
                           "5.", "+-5", "5,", "5%%"}) {
    EXPECT_EQ(parse_length(text), std::nullopt) << text;
  }
}

TEST(Length, OfAnAttributeMayBeFollowedByAnything) {
  EXPECT_EQ(parse_leading_length("5 px"), Length{5});
  EXPECT_EQ(parse_leading_length("5.,1"), Length{5});
  EXPECT_EQ(parse_leading_length("5parsec"), std::nullopt);
}

TEST(LengthList, IsSeparatedBySpaceOrOneComma) {
  EXPECT_THAT(parse_length_list(" 1,2px 3% , 4in ").value(),
              ElementsAre(Length{1}, Length{2}, Length{3, LengthUnit::kPercent},
                          Length{4, LengthUnit::kIn}));
  EXPECT_TRUE(parse_length_list("").value().empty());
  for (const char* text : {"1,,2", ",1", "1,", "1 2x", "none"}) {
    EXPECT_EQ(parse_length_list(text), std::nullopt) << text;
  }
}

TEST(Number, StandsAlone) {
  EXPECT_EQ(parse_number(" -1.5e1 "), -15);
  EXPECT_EQ(parse_number("1 2"), std::nullopt);
  EXPECT_EQ(parse_number("1px"), std::nullopt);
}

TEST(Opacity, IsPutBetweenZeroAndOne) {
  EXPECT_EQ(parse_opacity("0.25"), 0.25);
  EXPECT_EQ(parse_opacity("25%"), 0.25);
  EXPECT_EQ(parse_opacity("7"), 1);
  EXPECT_EQ(parse_opacity("-7%"), 0);
  EXPECT_EQ(parse_opacity(".5px"), 0.5);
  EXPECT_EQ(parse_opacity("half"), std::nullopt);
  EXPECT_EQ(parse_opacity("1em"), std::nullopt);
  EXPECT_EQ(parse_leading_opacity("50% or so"), 0.5);
}

}  // namespace
}  // namespace libstyle::svg
