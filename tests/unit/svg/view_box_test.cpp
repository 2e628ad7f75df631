// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/view_box.h"

#include <gtest/gtest.h>

#include <string>

namespace libstyle::svg {
namespace {

TEST(ViewBox, IsFourNumbers) {
  EXPECT_EQ(parse_view_box(" 1 -2,3 4.5 "), (Rectangle{1, -2, 3, 4.5}));
  EXPECT_EQ(parse_view_box("0 0 0 5"), (Rectangle{0, 0, 0, 5}));
  EXPECT_EQ(parse_view_box("1 2 3 4 5"), (Rectangle{1, 2, 3, 4}));
  for (const char* text :
       {"", "1 2 3", "1 2 3px 4", "1 2 3 4%", "1 2 3 4px", "0 0 -1 5", "0 0 1 -5"}) {
    EXPECT_EQ(parse_view_box(text), std::nullopt) << text;
  }
}

TEST(AspectRatio, ReadsEveryForm) {
  constexpr const char* kNames[] = {"Min", "Mid", "Max"};
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      const std::string align = std::string("x") + kNames[x] + "Y" + kNames[y];
      AspectRatio expected = {true, static_cast<Align>(x), static_cast<Align>(y), false, false};
      EXPECT_EQ(parse_aspect_ratio(align), expected);
      EXPECT_EQ(parse_aspect_ratio(align + " meet"), expected);
      expected.slice = true;
      EXPECT_EQ(parse_aspect_ratio(" " + align + "\n slice "), expected);
      expected.defer = true;
      EXPECT_EQ(parse_aspect_ratio("defer " + align + " slice"), expected);
    }
  }
  EXPECT_FALSE(parse_aspect_ratio("none").value().preserved);
  EXPECT_FALSE(parse_aspect_ratio("none slice").value().preserved);
}

TEST(AspectRatio, LooksNeitherAtCaseNorAtWhatFollows) {
  EXPECT_EQ(parse_aspect_ratio("xmaxYMIN"), parse_aspect_ratio("xMaxYMin"));
  EXPECT_EQ(parse_aspect_ratio("xMaxYMin cut"), parse_aspect_ratio("xMaxYMin"));
}

TEST(AspectRatio, RefusesAnythingElse) {
  for (const char* text :
       {"", "meet", "xMid", "YMidxMid", "xMidYMidd", "slice xMidYMid", "defer"}) {
    EXPECT_EQ(parse_aspect_ratio(text), std::nullopt) << text;
  }
}

TEST(ViewBox, MovesNothingForTheLastDigitOfAPage) {
  const Rectangle page = {0, 0, 29.7 / 2.54 * 96, 21 / 2.54 * 96};
  const Rectangle view_box = {0, 0, 1122.5196850393702, 793.7007874015748};
  EXPECT_EQ(viewport_from_view_box({0, 0, page.width + 1e-12, page.height}, view_box, {}),
            Transform{});
  EXPECT_NE(viewport_from_view_box({0, 0, page.width + 1e-6, page.height + 1e-6}, view_box, {}),
            Transform{});
}

// Where the corners of `view_box` come to lie in the viewport 100 200 40 20.
Rectangle placed(const Rectangle& view_box, std::string_view ratio) {
  const Transform map =
      viewport_from_view_box({100, 200, 40, 20}, view_box, parse_aspect_ratio(ratio).value())
          .value();
  const Point low = map({view_box.x, view_box.y});
  const Point high = map({view_box.x + view_box.width, view_box.y + view_box.height});
  return {low.x, low.y, high.x - low.x, high.y - low.y};
}

TEST(ViewportTransform, StretchesToFillWithNone) {
  EXPECT_EQ(placed({5, 6, 10, 10}, "none"), (Rectangle{100, 200, 40, 20}));
}

TEST(ViewportTransform, FitsAndAligns) {
  EXPECT_EQ(placed({5, 6, 10, 10}, "xMinYMid"), (Rectangle{100, 200, 20, 20}));
  EXPECT_EQ(placed({5, 6, 10, 10}, "xMidYMid"), (Rectangle{110, 200, 20, 20}));
  EXPECT_EQ(placed({5, 6, 10, 10}, "xMaxYMid"), (Rectangle{120, 200, 20, 20}));
}

TEST(ViewportTransform, CoversAndAlignsWithSlice) {
  EXPECT_EQ(placed({5, 6, 10, 10}, "xMidYMin slice"), (Rectangle{100, 200, 40, 40}));
  EXPECT_EQ(placed({5, 6, 10, 10}, "xMidYMid slice"), (Rectangle{100, 190, 40, 40}));
  EXPECT_EQ(placed({5, 6, 10, 10}, "xMidYMax slice"), (Rectangle{100, 180, 40, 40}));
}

TEST(ViewportTransform, IsNothingWhenNothingCanBeDrawn) {
  EXPECT_EQ(viewport_from_view_box({0, 0, 40, 20}, {0, 0, 0, 10}, {}), std::nullopt);
  EXPECT_EQ(viewport_from_view_box({0, 0, 0, 20}, {0, 0, 10, 10}, {}), std::nullopt);
  EXPECT_EQ(viewport_from_view_box({0, 0, 1e308, 1e308}, {0, 0, 1e-308, 1e-308}, {}), std::nullopt);
}

}  // namespace
}  // namespace libstyle::svg
