// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/css_color.h"

#include <gtest/gtest.h>

namespace libstyle::svg {
namespace {

// "#rrggbb", with " alpha" behind it when that is not 1; "-" for what is no colour.
std::string read(std::string_view text) {
  const std::optional<CssColor> color = parse_css_color(text);
  if (!color) return "-";
  return to_text(color->color) + (color->alpha == 1 ? "" : " " + std::to_string(color->alpha));
}

TEST(CssColor, ReadsHexadecimalDigits) {
  EXPECT_EQ(read("#1aF"), "#11aaff");
  EXPECT_EQ(read(" #0c8040 "), "#0c8040");
  EXPECT_EQ(read("#0c804033"), "#0c8040 0.200000");
  EXPECT_EQ(read("#1af3"), "#11aaff 0.200000");
  EXPECT_EQ(read("#1afF"), "#11aaff");
}

TEST(CssColor, ReadsNamesInAnyCase) {
  EXPECT_EQ(read("aliceblue"), "#f0f8ff");
  EXPECT_EQ(read("Red"), "#ff0000");
  EXPECT_EQ(read("SlateGrey"), "#708090");
  EXPECT_EQ(read("slategray"), "#708090");
  EXPECT_EQ(read("rebeccapurple"), "#663399");
  EXPECT_EQ(read("yellowgreen"), "#9acd32");
  EXPECT_EQ(read("transparent"), "#000000 0.000000");
}

TEST(CssColor, KnowsAllPairsOfGrayAndGrey) {
  for (const std::string stem : {"", "dark", "darkslate", "dim", "light", "lightslate", "slate"}) {
    EXPECT_NE(read(stem + "gray"), "-");
    EXPECT_EQ(read(stem + "gray"), read(stem + "grey"));
  }
}

TEST(CssColor, ReadsRgbInNumbersAndPercent) {
  EXPECT_EQ(read("rgb(1, 20, 255)"), "#0114ff");
  EXPECT_EQ(read("RGB(1,20,255)"), "#0114ff");
  EXPECT_EQ(read("rgb( 1 20 255 )"), "#0114ff");
  EXPECT_EQ(read("rgb(100%, 50%, 0%)"), "#ff8000");
  EXPECT_EQ(read("rgba(1, 20, 255, 0.25)"), "#0114ff 0.250000");
  EXPECT_EQ(read("rgb(1 20 255 / 25%)"), "#0114ff 0.250000");
}

TEST(CssColor, PutsValuesIntoTheirRange) {
  EXPECT_EQ(read("rgb(300, -5, 0)"), "#ff0000");
  EXPECT_EQ(read("rgb(110%, -1%, 0%)"), "#ff0000");
  EXPECT_EQ(read("rgba(0, 0, 0, 7)"), "#000000");
  EXPECT_EQ(read("hsl(0, 200%, 50%)"), "#ff0000");
}

TEST(CssColor, ReadsHues) {
  EXPECT_EQ(read("hsl(0, 100%, 50%)"), "#ff0000");
  EXPECT_EQ(read("hsl(120deg 100% 25%)"), "#008000");
  EXPECT_EQ(read("hsl(-120, 100%, 50%)"), "#0000ff");
  EXPECT_EQ(read("hsl(600, 100%, 50%)"), "#0000ff");
  EXPECT_EQ(read("hsla(0.5turn, 100%, 50%, .5)"), "#00ffff 0.500000");
  EXPECT_EQ(read("hsl(77, 0%, 50%)"), "#808080");
}

TEST(CssColor, ClosesWhatIsLeftOpen) { EXPECT_EQ(read("rgb(1,2,3"), "#010203"); }

TEST(CssColor, RefusesWhatIsNoColor) {
  for (const char* text : {"",
                           "none",
                           "currentColor",
                           "#",
                           "#12",
                           "#12345",
                           "#1234567",
                           "#12g",
                           "reddish",
                           "rgb",
                           "rgb()",
                           "rgb(1,2)",
                           "rgb(1,2%,3)",
                           "rgb(1,2 3)",
                           "rgb(1,2,3,4,5)",
                           "rgb(1 2 3 4)",
                           "rgb(1,2,3) x",
                           "rgb(1,2,3,)",
                           "rgb (1,2,3)",
                           "hsl(1,2,3)",
                           "hsl(1px,2%,3%)",
                           "hsl(1e308turn,2%,3%)",
                           "url(#a)",
                           "lab(1 2 3)"}) {
    EXPECT_EQ(read(text), "-") << text;
  }
}

}  // namespace
}  // namespace libstyle::svg
