// SPDX-License-Identifier: Apache-2.0
// Text as curves. The fonts are those of fonts-dejavu-core.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libstyle/geometry/path_segments.h"
#include "tests/unit/svg/reading.h"

namespace libstyle::svg {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A text in DejaVu Sans, 40 px high, that begins at 10, 50.
std::string text(const std::string& content, const std::string& attributes = "") {
  return "<text font-family='DejaVu Sans' font-size='40' x='10' y='50' " + attributes + ">" +
         content + "</text>";
}

Box box(const PathRecord& path) { return bounding_box(path.path); }

Box box_of_all(const Reading& reading) {
  Box all;
  for (const PathRecord* const path : reading.paths()) all.include(box(*path));
  return all;
}

std::vector<std::string> fills(const Reading& reading) {
  std::vector<std::string> fills;
  for (const PathRecord* const path : reading.paths()) {
    fills.push_back(to_text(std::get<Color>(path->style.fill.value())));
  }
  return fills;
}

std::vector<std::string> ids(const Reading& reading) {
  std::vector<std::string> ids;
  for (const PathRecord* const path : reading.paths()) ids.push_back(path->id);
  return ids;
}

TEST(Text, HasSmoothEdgesAmongCrispShapes) {
  const Reading reading =
      read("<g shape-rendering='crispEdges'>" + text("l") + text("l<tspan>l</tspan>") + "</g>");
  ASSERT_EQ(reading.paths().size(), 3U);
  for (const PathRecord* const path : reading.paths()) EXPECT_FALSE(path->style.crisp_edges);
}

// --- Geometry -----------------------------------------------------------------------------------

// The font has 2048 units to the em. "l" is a box from (193, 0) to (377, 1556).
TEST(Text, HasTheOutlinesOfTheFont) {
  const Reading reading = read(text("l"));
  EXPECT_THAT(reading.warnings, IsEmpty());
  const Box l = box(reading.path());
  EXPECT_NEAR(l.low.x, 10 + 40 * 193 / 2048.0, 0.001);
  EXPECT_NEAR(l.high.x, 10 + 40 * 377 / 2048.0, 0.001);
  EXPECT_NEAR(l.low.y, 50 - 40 * 1556 / 2048.0, 0.001);
  EXPECT_NEAR(l.high.y, 50, 0.001);
}

TEST(Text, IsAsExactWhenItIsSmall) {
  const Box small =
      box(read("<text font-family='DejaVu Sans' font-size='0.01' x='5'>l</text>").path());
  EXPECT_NEAR(small.width(), 0.01 * 184 / 2048, 1e-6);
  EXPECT_NEAR(small.height(), 0.01 * 1556 / 2048, 1e-6);
}

TEST(Text, FollowsTransformsAndViewBoxes) {
  const Box plain = box(read(text("l")).path());
  const Box moved = box(
      read("<svg width='200' height='200' viewBox='0 0 100 100'><g transform='translate(3 4)'>" +
           text("l") + "</g></svg>")
          .path());
  EXPECT_NEAR(moved.low.x, 2 * (plain.low.x + 3), 1e-9);
  EXPECT_NEAR(moved.high.y, 2 * (plain.high.y + 4), 1e-9);
}

TEST(Text, StandsWhereItIsAnchored) {
  const double begin = box(read(text("ll")).path()).low.x;
  const double middle = box(read(text("ll", "text-anchor='middle'")).path()).low.x;
  const double end = box(read(text("ll", "text-anchor='end'")).path()).low.x;
  const double advance = 2 * 40 * 569 / 2048.0;
  EXPECT_NEAR(begin - middle, advance / 2, 0.01);
  EXPECT_NEAR(begin - end, advance, 0.01);
}

TEST(Text, MovesByPositionsInAnyUnit) {
  EXPECT_NEAR(box(read(text("<tspan x='50%' y='1in'>l</tspan>")).path()).high.y, 96, 0.001);
  EXPECT_NEAR(box(read(text("<tspan dx='1em' dy='-10'>l</tspan>")).path()).high.y, 40, 0.001);
  const double right = box(read(text("<tspan dx='1em'>l</tspan>")).path()).low.x;
  EXPECT_NEAR(right - box(read(text("l")).path()).low.x, 40, 0.001);
}

// Four boxes of four corners each. The last one follows the one before.
TEST(Text, PlacesEveryCharacterThatHasAPlace) {
  const Reading reading = read(text("<tspan x='10, 60 30' dy='0 0 -5'>\n  llll</tspan>"));
  EXPECT_THAT(reading.warnings, IsEmpty());
  const std::vector<Point> corners = reading.path().path.vertices();
  ASSERT_EQ(corners.size(), 16U);
  EXPECT_NEAR(corners[4].x - corners[0].x, 50, 0.001);
  EXPECT_NEAR(corners[8].x - corners[0].x, 20, 0.001);
  EXPECT_NEAR(corners[12].x - corners[8].x, 40 * 569 / 2048.0, 0.001);
  EXPECT_NEAR(corners[4].y - corners[0].y, 0, 0.001);
  EXPECT_NEAR(corners[8].y - corners[4].y, -5, 0.001);
  EXPECT_NEAR(corners[12].y - corners[8].y, 0, 0.001);
}

TEST(Text, KeepsTheWordSpaceBetweenTwoElements) {
  const Box apart = box_of_all(read(text("<tspan>l</tspan> <tspan>l</tspan>")));
  const Box together = box_of_all(read(text("<tspan>l</tspan><tspan>l</tspan>")));
  EXPECT_NEAR(apart.width() - together.width(), 40 * 651 / 2048.0, 0.01);
}

TEST(Text, KeepsSpacesWhereItIsAskedTo) {
  EXPECT_GT(box(read(text("l   l", "xml:space='preserve'")).path()).width(),
            box(read(text("l   l")).path()).width() + 20);
}

TEST(Text, TakesCharactersAsTheFileMeansThem) {
  const std::string plain = to_path_data(read(text("A&amp;B")).path().path);
  EXPECT_EQ(read(text("&#65;<![CDATA[&]]>B")).path_data(), plain);
  EXPECT_EQ(read_file("<!DOCTYPE svg [<!ENTITY both 'A&amp;B'>]><svg width='100' height='100'>" +
                      text("&both;") + "</svg>")
                .path_data(),
            plain);
  EXPECT_EQ(read_file("<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:text font-size='40' x='10' "
                      "y='50' font-family='DejaVu Sans'>A&amp;<s:tspan/>B</s:text></s:svg>")
                .paths()
                .size(),
            1U);
}

TEST(Text, IsTheSameEveryTime) {
  const std::string drawing = text("Some <tspan fill='red'>words</tspan> more");
  EXPECT_EQ(read(drawing).document, read(drawing).document);
}

// --- Paint and structure ------------------------------------------------------------------------

TEST(Text, IsOnePathOfItsElement) {
  const PathRecord path =
      read(text("word", "id='t' class='big' data-of='7' fill='red' opacity='0.5'")).path();
  EXPECT_EQ(path.id, "t");
  EXPECT_EQ(path.classes, "big");
  EXPECT_EQ(path.extras.size(), 1U);
  EXPECT_EQ(path.shape, "text");
  EXPECT_EQ(path.style.opacity, 0.5);
  EXPECT_EQ(path.style.fill, Paint(Color{255, 0, 0}));
}

TEST(Text, LetsEverySpanKeepItsFill) {
  const Reading reading =
      read(text("a<tspan id='s' fill='red'>b<tspan fill='blue'>c</tspan></tspan>d", "id='t'"));
  EXPECT_THAT(fills(reading), ElementsAre("#000000", "#ff0000", "#0000ff", "#000000"));
  ASSERT_EQ(reading.groups().size(), 2U);
  EXPECT_EQ(reading.groups()[0]->id, "t");
  EXPECT_EQ(reading.groups()[1]->id, "s");
  EXPECT_EQ(reading.groups()[1]->parent, "t");
  EXPECT_EQ(reading.paths()[0]->parent, "t");
  EXPECT_EQ(reading.paths()[1]->parent, "s");
  EXPECT_EQ(reading.paths()[3]->parent, "t");
}

TEST(Text, IsPaintedInItsPlace) {
  EXPECT_THAT(
      ids(read("<path id='a' d='M0 0H1'/>" + text("b", "id='b'") + "<path id='c' d='M0 0H1'/>")),
      ElementsAre("a", "b", "c"));
}

TEST(Text, IsClippedAndFadedAsAWhole) {
  const Reading reading =
      read("<clipPath id='c'><rect width='50' height='50'/></clipPath>" +
           text("a<tspan opacity='0.1'>b</tspan>", "opacity='0.5' clip-path='url(#c)'"));
  EXPECT_EQ(reading.group().opacity, 0.5);
  EXPECT_EQ(reading.group().clip, "c");
  for (const PathRecord* const path : reading.paths()) {
    EXPECT_EQ(path->style.opacity, 1);
    EXPECT_EQ(path->clip, "");
  }
}

TEST(Text, IsStyledBySheets) {
  SvgReadOptions options;
  options.style_sheet = ".late { fill: blue; font-size: 20px !important }";
  const Reading reading =
      read_file("<svg width='100' height='100'><style>tspan { font-size: 80px }</style>" +
                    text("<tspan>l</tspan><tspan class='late'>l</tspan>") + "</svg>",
                options);
  EXPECT_NEAR(box(*reading.paths()[0]).height(), 80 * 1556 / 2048.0, 0.01);
  EXPECT_NEAR(box(*reading.paths()[1]).height(), 20 * 1556 / 2048.0, 0.01);
  EXPECT_THAT(fills(reading), ElementsAre("#000000", "#0000ff"));
}

TEST(Text, IsDrawnByUseAsItIsStyledThere) {
  const Reading reading = read(
      "<defs><text id='t' font-family='DejaVu Sans'>l</text></defs>"
      "<use xlink:href='#t' x='20' y='30' font-size='40' fill='red'/>");
  EXPECT_NEAR(box(reading.path()).high.y, 30, 0.001);
  EXPECT_NEAR(box(reading.path()).height(), 40 * 1556 / 2048.0, 0.001);
  EXPECT_THAT(fills(reading), ElementsAre("#ff0000"));
}

TEST(Text, ClipsByItsOutlines) {
  const Reading reading = read("<clipPath id='c'>" + text("l<tspan>l</tspan>") +
                               "</clipPath><rect width='99' height='99' clip-path='url(#c)'/>");
  ASSERT_EQ(reading.clips().size(), 1U);
  ASSERT_EQ(reading.clips()[0]->parts.size(), 1U);
  EXPECT_EQ(subpaths(reading.clips()[0]->parts[0].path).size(), 2U);
}

TEST(Text, HasTheBoxOfAllItsPartsForGradients) {
  const Reading reading = read("<linearGradient id='g'><stop stop-color='red'/></linearGradient>" +
                               text("l<tspan>ll</tspan>", "fill='url(#g)'"));
  ASSERT_EQ(reading.gradients().size(), 1U);
  EXPECT_NEAR(reading.gradients()[0]->page_from_gradient.a, box_of_all(reading).width(), 0.001);
}

TEST(Text, HasOneBoxForGradientsWhenItIsTurnedToo) {
  const Reading reading = read("<linearGradient id='g'><stop stop-color='red'/></linearGradient>" +
                               text("l<tspan>ll</tspan>", "fill='url(#g)' transform='rotate(30)'"));
  EXPECT_EQ(reading.paths().size(), 2U);
  EXPECT_EQ(reading.gradients().size(), 1U);
}

TEST(Text, KeepsWhatIsHiddenAsHidden) {
  EXPECT_TRUE(read(text("a", "visibility='hidden'")).path().style.hidden);
  EXPECT_TRUE(read(text("a", "display='none'")).path().style.hidden);
  const Reading reading = read(text("a<tspan visibility='hidden'>b</tspan>"));
  EXPECT_FALSE(reading.paths()[0]->style.hidden);
  EXPECT_TRUE(reading.paths()[1]->style.hidden);
}

// The place of a part that is not displayed is taken by what follows.
TEST(Text, ClosesTheGapOfWhatIsNotDisplayed) {
  EXPECT_EQ(read(text("l<tspan display='none'>l</tspan>l")).path_data(),
            read(text("ll")).path_data());
}

TEST(Text, BorrowsCharactersByTref) {
  EXPECT_EQ(
      read("<defs><text id='t'>l<tspan>l</tspan></text></defs>" + text("<tref xlink:href='#t'/>"))
          .path_data(),
      read(text("ll")).path_data());
  EXPECT_THAT(read(text("<tref xlink:href='#none'/>")).warning_texts(),
              ElementsAre(HasSubstr("which is not in the file")));
}

TEST(Text, WithoutCharactersIsNothing) {
  EXPECT_THAT(read(text("")).document.records, IsEmpty());
  EXPECT_THAT(read(text("  <tspan> </tspan>")).document.records, IsEmpty());
  EXPECT_THAT(read("<text font-size='0'>a</text>").document.records, IsEmpty());
}

// --- Limits -------------------------------------------------------------------------------------

TEST(Text, SaysWhatItDoesNotCarry) {
  EXPECT_THAT(read(text("a<textPath>b</textPath>", "rotate='5' id='t'")).warning_texts(),
              ElementsAre("1 #t rotate is not carried", "1 textPath is not carried"));
  EXPECT_THAT(read("<text x='left'>a</text>").warning_texts(),
              ElementsAre("1 x has an error; it is read up to there"));
}

TEST(Text, IsLeftOutWhenItIsTooLong) {
  SvgReadOptions options;
  options.limits.text_length = 3;
  const Reading reading =
      read_file("<svg><text>abcd</text><text>abc<tspan>abc</tspan></text></svg>", options);
  EXPECT_EQ(reading.paths().size(), 2U);
  EXPECT_THAT(reading.warning_texts(),
              ElementsAre("1 is left out: it has more than 3 characters in one piece"));
}

TEST(Text, IsLeftOutBeyondTheCharactersOfAFile) {
  SvgReadOptions options;
  options.limits.text_work = 100;
  const Reading used = read_file(
      "<svg><defs><text id='t'>ab</text></defs>"
      "<use href='#t'/><use href='#t'/><use href='#t'/><use href='#t'/>"
      "<use href='#t'/><use href='#t'/><use href='#t'/></svg>",
      options);
  EXPECT_EQ(used.paths().size(), 5U);
  EXPECT_THAT(used.warning_texts(),
              ElementsAre("1 #t is left out: the file has more than 100 characters of text"));
  const Reading parts = read_file(
      "<svg><text>a<tspan/><tspan/><tspan/><tspan/><tspan/><tspan/></text></svg>", options);
  EXPECT_THAT(parts.paths(), IsEmpty());
  EXPECT_EQ(parts.warnings.size(), 1U);
}

TEST(Text, SurvivesSizesBeyondReason) {
  for (const char* const attributes :
       {"font-size='1e300'", "font-size='1e-300'", "x='1e300'", "letter-spacing='1e300'",
        "dy='-1e300'", "baseline-shift='1e300'", "y='1e30' font-size='1e-30'"}) {
    const Reading reading =
        read("<text " + std::string(attributes) + ">ab<tspan x='0'>c</tspan></text>");
    for (const PathRecord* const path : reading.paths()) {
      for (const Point point : path->path.points()) EXPECT_TRUE(is_finite(point)) << attributes;
    }
  }
}

TEST(Text, LeavesOutWhatIsNestedTooDeep) {
  std::string content;
  for (int i = 0; i < 400; ++i) content = "a<tspan>" + content + "</tspan>";
  const Reading reading = read(text(content));
  EXPECT_THAT(reading.warning_texts(), ElementsAre("1 is nested too deep; it is left out"));
  EXPECT_EQ(reading.paths().size(), 200U);
}

// Outlines overlap where strokes of a letter meet.
TEST(Text, FillsItsOutlinesAsFontsMeanThem) {
  const Reading reading =
      read(text("a<tspan fill-rule='evenodd'>b</tspan>", "fill-rule='evenodd'"));
  for (const PathRecord* const path : reading.paths()) {
    EXPECT_EQ(path->style.fill_rule, FillRule::kNonZero);
  }
  EXPECT_EQ(read(text("a", "fill-rule='evenodd'")).path().style.fill_rule, FillRule::kNonZero);
}

TEST(Text, IsExactFarFromTheOrigin) {
  const Box far = box(read("<text font-family='DejaVu Sans' font-size='10'><tspan x='1000000' "
                           "y='-2000000'>l</tspan></text>")
                          .path());
  EXPECT_NEAR(far.width(), 10 * 184 / 2048.0, 0.001);
  EXPECT_NEAR(far.high.y, -2000000, 0.001);
}

TEST(Text, TakesCharactersThatXmlCannotHold) {
  EXPECT_EQ(read(text("a&#1;b&#xFFFE;c&#xD800;")).paths().size(), 1U);
}

}  // namespace
}  // namespace libstyle::svg
