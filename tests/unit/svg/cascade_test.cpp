// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/cascade.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/svg/reading.h"

namespace libstyle::svg {
namespace {

// The fill that a path comes to have: "#rrggbb" or "none".
std::string fill_of(const PathRecord& path) {
  if (!path.style.fill) return "unset";
  const auto* const color = std::get_if<Color>(&*path.style.fill);
  return color == nullptr ? "none" : to_text(*color);
}

// The fill of the one shape in `inside`, with a style sheet before it.
std::string fill(const std::string& sheet, const std::string& inside) {
  return fill_of(read("<style>" + sheet + "</style>" + inside).path());
}

constexpr const char* kRed = "#ff0000";
constexpr const char* kBlue = "#0000ff";

TEST(Cascade, BeginsWithBlackFill) { EXPECT_EQ(fill("", "<path d='M0 0H1'/>"), "#000000"); }

TEST(Cascade, InheritsFromGroups) {
  EXPECT_EQ(fill("", "<g fill='red'><g><path d='M0 0H1'/></g></g>"), kRed);
  EXPECT_EQ(fill("", "<g fill='red'><path d='M0 0H1' fill='blue'/></g>"), kBlue);
}

TEST(Cascade, DoesNotInheritOpacity) {
  EXPECT_EQ(read("<g opacity='.5'><path d='M0 0H1'/></g>").path().style.opacity, 1);
}

TEST(Cascade, InheritsAnythingOnRequest) {
  const Reading reading =
      read("<g opacity='.5' fill='red'><path d='M0 0H1' fill='inherit' opacity='inherit'/></g>");
  EXPECT_EQ(reading.path().style.opacity, 0.5);
  EXPECT_EQ(fill_of(reading.path()), kRed);
}

TEST(Cascade, LetsSheetsWinOverAttributes) {
  EXPECT_EQ(fill("path{fill:red}", "<path d='M0 0H1' fill='blue'/>"), kRed);
}

TEST(Cascade, LetsTheStyleAttributeWinOverSheets) {
  EXPECT_EQ(fill("#p{fill:red}", "<path id='p' d='M0 0H1' style='fill:blue'/>"), kBlue);
}

TEST(Cascade, LetsImportantWinOverTheStyleAttribute) {
  EXPECT_EQ(fill("path{fill:red!important}", "<path d='M0 0H1' style='fill:blue'/>"), kRed);
  EXPECT_EQ(fill("path{fill:red !important}", "<path d='M0 0H1' style='fill:blue ! important'/>"),
            kBlue);
}

TEST(Cascade, OrdersRulesBySpecificityThenPlace) {
  EXPECT_EQ(fill(".a{fill:red} path{fill:blue}", "<path class='a' d='M0 0H1'/>"), kRed);
  EXPECT_EQ(fill(".a{fill:red} .b{fill:blue}", "<path class='b a' d='M0 0H1'/>"), kBlue);
}

TEST(Cascade, DropsWrongValuesAndKeepsEarlierOnes) {
  EXPECT_EQ(fill("path{fill:red; fill:no-colour}", "<path d='M0 0H1'/>"), kRed);
  EXPECT_EQ(fill("path{fill:red} .a{fill:rgb(1)}", "<path class='a' d='M0 0H1'/>"), kRed);
}

TEST(Cascade, KnowsNamesInLowerCaseOnly) {
  EXPECT_EQ(fill("path{FILL:red}", "<path d='M0 0H1' fill='blue' style='Fill:red'/>"), kBlue);
}

TEST(Cascade, TakesBlendModesFromStyleAlone) {
  EXPECT_THAT(read("<path d='M0 0H1' mix-blend-mode='multiply'/>").groups(), testing::IsEmpty());
}

TEST(Cascade, DoesNotKnowTheWordInitial) {
  EXPECT_EQ(fill("", "<g fill='red'><path d='M0 0H1' fill='initial'/></g>"), kRed);
}

TEST(Cascade, ReadsColorsOfProfilesAsErrors) {
  EXPECT_EQ(fill("", "<g fill='red'><path d='M0 0H1' fill='blue icc-color(a, 1)'/></g>"), kRed);
}

TEST(Cascade, ReadsSheetsOfAnyTypeAndCommentsInAttributes) {
  EXPECT_EQ(
      fill_of(read("<style type='text/plain'>path{fill:red}</style><path d='M0 0H1'/>").path()),
      kRed);
  EXPECT_EQ(fill("", "<path d='M0 0H1' fill='/**/red'/>"), kRed);
}

TEST(Cascade, ReadsSheetsInCommentsAndCdata) {
  EXPECT_EQ(fill("<![CDATA[ path{fill:red} ]]>", "<path d='M0 0H1'/>"), kRed);
  EXPECT_EQ(fill("/* path{fill:blue} */ path{/**/fill/**/:/**/red}", "<path d='M0 0H1'/>"), kRed);
}

TEST(Cascade, ReadsSheetsWhereverTheyStand) {
  EXPECT_EQ(fill_of(read("<path d='M0 0H1'/><defs><style>path{fill:red}</style></defs>").path()),
            kRed);
}

TEST(Cascade, PassesOverAtRules) {
  const Reading reading = read(
      "<style>@charset 'utf-8'; @font-face{src:url(a.ttf)} @media print{"
      "path{fill:blue}} path{fill:red}</style><path d='M0 0H1'/>");
  EXPECT_EQ(fill_of(reading.path()), kRed);
  EXPECT_THAT(reading.warning_texts(), testing::ElementsAre(testing::HasSubstr("@media")));
}

TEST(Cascade, WarnsAboutSelectorsItDoesNotKnow) {
  const Reading reading =
      read("<style>path::before{fill:blue} path{fill:red}</style><path d='M0 0H1'/>");
  EXPECT_EQ(fill_of(reading.path()), kRed);
  EXPECT_THAT(reading.warning_texts(), testing::ElementsAre(testing::HasSubstr("path::before")));
}

TEST(Cascade, ResolvesCurrentColorWhereItIsUsed) {
  EXPECT_EQ(fill("", "<g color='blue' fill='currentColor'><path color='red' d='M0 0H1'/></g>"),
            kRed);
  EXPECT_EQ(fill("", "<g color='red'><path fill='currentColor' d='M0 0H1'/></g>"), kRed);
}

TEST(Cascade, PutsAlphaIntoOpacity) {
  const Style style =
      read("<path d='M0 0H1' fill='rgba(255,0,0,.5)' fill-opacity='.5'/>").path().style;
  EXPECT_EQ(style.fill, Paint(Color{255, 0, 0}));
  EXPECT_DOUBLE_EQ(style.fill_opacity, 0.25);
}

TEST(Cascade, FallsBackWhereAReferenceLeadsNowhere) {
  EXPECT_EQ(fill("", "<path fill='url(#none) red' d='M0 0H1'/>"), kRed);
  EXPECT_EQ(fill("", "<path fill='url(#none)' d='M0 0H1'/>"), "none");
}

TEST(Cascade, TakesTheStyleSheetOfTheUserLast) {
  SvgReadOptions options;
  options.style_sheet = "path{fill:red}";
  const Reading reading =
      read_file("<svg><style>path{fill:blue}</style><path d='M0 0H1'/></svg>", options);
  EXPECT_EQ(fill_of(reading.path()), kRed);
}

TEST(Cascade, RefusesStyleSheetsMadeToBeSlow) {
  std::string text = "<svg><style>x g g g g g g g g g g g{fill:red}</style>";
  for (int i = 0; i < 200; ++i) text += "<g>";
  for (int i = 0; i < 200; ++i) text += "</g>";
  SvgReadOptions options;
  options.limits.match_steps = 100'000;
  EXPECT_THAT(read_error(text + "</svg>", options), testing::HasSubstr("takes too long to match"));
}

TEST(Cascade, ResolvesFontSizesForLengthsInEm) {
  const auto width = [](const std::string& inside) {
    return read(inside).path().style.stroke_width;
  };
  EXPECT_DOUBLE_EQ(width("<g font-size='10'><g font-size='2em'><path d='M0 0H1' stroke='red' "
                         "stroke-width='1em'/></g></g>"),
                   20);
  EXPECT_DOUBLE_EQ(width("<g font-size='10'><path font-size='50%' d='M0 0H1' stroke='red' "
                         "stroke-width='2em'/></g>"),
                   10);
}

TEST(Cascade, LetsTheTransformPropertyWinOverTheAttribute) {
  EXPECT_EQ(read("<path d='M0 0L1 0' transform='scale(2)' style='transform:translate(5px,6px)'/>")
                .path_data(),
            "M5 6 L6 6");
}

}  // namespace
}  // namespace libstyle::svg
