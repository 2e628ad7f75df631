// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/font_property.h"

#include <gtest/gtest.h>

namespace libstyle::svg {
namespace {

std::optional<Font> parse(std::string_view text) { return parse_font(text, 20, 700); }

TEST(FontProperty, ReadsTheShorthand) {
  const Font font = parse("italic bold 12px/1.5 'Two Words', serif").value();
  EXPECT_EQ(font.style, "italic");
  EXPECT_EQ(font.weight, 700);
  EXPECT_EQ(font.size, 12);
  EXPECT_EQ(font.family, "'Two Words', serif");
}

TEST(FontProperty, PutsWhatTheShorthandLeavesOutToItsInitialValue) {
  const Font font = parse("2em serif").value();
  EXPECT_EQ(font.weight, 400);
  EXPECT_EQ(font.style, "");
  EXPECT_EQ(font.size, 40);
}

TEST(FontProperty, TakesTraitsInAnyOrder) {
  const Font font = parse("condensed normal 300 small-caps oblique 9pt a").value();
  EXPECT_EQ(font.stretch, "condensed");
  EXPECT_EQ(font.weight, 300);
  EXPECT_EQ(font.variant, "small-caps");
  EXPECT_EQ(font.style, "oblique");
  EXPECT_EQ(font.size, 12);
}

TEST(FontProperty, TakesTheHeightOfALineWithSpacesAroundIt) {
  for (const char* const text : {"9px/2 a", "9px /2 a", "9px/ 2 a", "9px / 2 a"}) {
    EXPECT_EQ(parse(text).value().family, "a") << text;
  }
}

TEST(FontProperty, RefusesAShorthandWithoutSizeOrFamily) {
  for (const char* const text : {"", "bold", "12px", "bold serif", "12px/2", "12px/", "caption"}) {
    EXPECT_FALSE(parse(text)) << text;
  }
}

TEST(FontProperty, StepsFromTheWeightOfTheParent) {
  EXPECT_EQ(parse_font_weight("bolder", 400), 700);
  EXPECT_EQ(parse_font_weight("bolder", 100), 400);
  EXPECT_EQ(parse_font_weight("bolder", 700), 900);
  EXPECT_EQ(parse_font_weight("lighter", 700), 400);
  EXPECT_EQ(parse_font_weight("lighter", 400), 100);
  EXPECT_EQ(parse_font_weight("650", 400), 650);
  EXPECT_FALSE(parse_font_weight("0", 400));
  EXPECT_FALSE(parse_font_weight("heavy", 400));
}

}  // namespace
}  // namespace libstyle::svg
