// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/markers.h"

#include <gmock/gmock.h>

#include <cmath>

#include "converters/svg/path_grammar.h"
#include "tests/unit/svg/reading.h"

namespace libstyle::svg {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// "start 0,0 45" and so on: place, position, direction in degrees.
std::vector<std::string> vertices_of(std::string_view d) {
  constexpr const char* kNames[] = {"start", "mid", "end"};
  std::vector<std::string> texts;
  for (const MarkerVertex& vertex : marker_vertices(parse_path_vertices(d))) {
    const double degrees = std::atan2(vertex.direction.y, vertex.direction.x) * 57.29577951308232;
    texts.push_back(std::string(kNames[static_cast<int>(vertex.place)]) + " " +
                    std::to_string(std::lround(vertex.position.x)) + "," +
                    std::to_string(std::lround(vertex.position.y)) + " " +
                    std::to_string(std::lround(degrees)));
  }
  return texts;
}

TEST(MarkerVertices, LookAlongThePathAndHalfwayAtCorners) {
  EXPECT_THAT(vertices_of("M0 0H10V10"), ElementsAre("start 0,0 0", "mid 10,0 45", "end 10,10 90"));
  EXPECT_THAT(vertices_of("M0 0C0 5 5 10 10 10"), ElementsAre("start 0,0 90", "end 10,10 0"));
}

TEST(MarkerVertices, CountTheClosingLine) {
  EXPECT_THAT(
      vertices_of("M0 0H10V10H0Z"),
      ElementsAre("start 0,0 0", "mid 10,0 45", "mid 10,10 135", "mid 0,10 -135", "end 0,0 -45"));
}

TEST(MarkerVertices, SkipTheEndsOfSubpathsButTheLast) {
  EXPECT_THAT(vertices_of("M0 0H10M20 0V9"),
              ElementsAre("start 0,0 0", "mid 20,0 45", "end 20,9 90"));
  EXPECT_THAT(vertices_of("M0 0H10V9ZM20 0V9Z"),
              ElementsAre("start 0,0 0", "mid 10,0 45", "mid 10,9 156", "mid 20,0 156",
                          "mid 20,9 180", "end 20,0 -90"));
}

TEST(MarkerVertices, StandOnPointsAlone) {
  EXPECT_THAT(vertices_of("M5 5"), ElementsAre("mid 5,5 0"));
  EXPECT_THAT(vertices_of("M1 1M5 5V9M7 7"),
              ElementsAre("mid 1,1 0", "start 5,5 90", "end 5,9 90", "mid 7,7 0"));
}

TEST(MarkerVertices, CountAClosingLineWithoutLength) {
  EXPECT_THAT(vertices_of("M0 0H10V10H0V0Z"),
              ElementsAre("start 0,0 0", "mid 10,0 45", "mid 10,10 135", "mid 0,10 -135",
                          "mid 0,0 -90", "end 0,0 -45"));
}

TEST(MarkerVertices, TakeTheDirectionOfNeighboursWhereThereIsNone) {
  EXPECT_THAT(vertices_of("M0 0H10H10V10"),
              ElementsAre("start 0,0 0", "mid 10,0 45", "mid 10,0 45", "end 10,10 90"));
  EXPECT_THAT(vertices_of("M5 5H5"), ElementsAre("start 5,5 0", "end 5,5 0"));
}

TEST(MarkerVertices, DoNotSeeThePiecesOfAnArc) {
  EXPECT_THAT(vertices_of("M0 0A10 10 0 0 1 20 0"), ElementsAre("start 0,0 -90", "end 20,0 90"));
}

TEST(MarkerVertices, GoAcrossWhereThePathTurnsBack) {
  EXPECT_THAT(vertices_of("M0 0H10H0")[1], "mid 10,0 90");
}

std::string marker(const std::string& attributes) {
  return "<marker id='m' overflow='visible' " + attributes +
         "><path id='tip' d='M0 0H1'/></marker>";
}

// Where the marker's line is drawn at the start of a path with a stroke 2 wide.
std::string first_marker(const std::string& attributes) {
  const Reading reading =
      read(marker(attributes) + "<path d='M10 20V30' stroke-width='2' marker-start='url(#m)'/>");
  EXPECT_THAT(reading.paths(), SizeIs(2));
  return reading.path_data(1);
}

TEST(Markers, AreAsLargeAsTheStrokeIsWide) {
  EXPECT_EQ(first_marker(""), "M10 20 L12 20");
  EXPECT_EQ(first_marker("markerUnits='userSpaceOnUse'"), "M10 20 L11 20");
}

TEST(Markers, TurnWithThePath) {
  EXPECT_EQ(first_marker("orient='auto'"), "M10 20 L10 22");
  EXPECT_EQ(first_marker("orient='auto-start-reverse'"), "M10 20 L10 18");
  EXPECT_EQ(first_marker("orient='180'"), "M10 20 L8 20");
  EXPECT_EQ(first_marker("orient='180deg'"), "M10 20 L8 20");
  EXPECT_EQ(first_marker("orient='.5turn'"), "M10 20 L12 20");
}

TEST(Markers, PutTheirReferencePointOnTheVertex) {
  EXPECT_EQ(first_marker("refX='1' refY='3'"), "M8 14 L10 14");
  EXPECT_EQ(first_marker("refX='50%' markerWidth='4'"), "M6 20 L8 20");
}

TEST(Markers, LayTheirViewBoxIntoTheirSize) {
  EXPECT_EQ(first_marker("viewBox='0 0 6 6'"), "M10 20 L11 20");
  EXPECT_EQ(first_marker("viewBox='0 0 6 6' refX='6'"), "M4 20 L5 20");
}

TEST(Markers, StandAtEveryVertexOfTheLinesTheyAreFor) {
  const std::string style = " style='marker: url(#m)'/>";
  EXPECT_THAT(read(marker("") + "<path d='M0 0H9V9'" + style).paths(), SizeIs(4));
  EXPECT_THAT(read(marker("") + "<line x2='9'" + style).paths(), SizeIs(3));
  EXPECT_THAT(read(marker("") + "<polygon points='0 0 1 1 2 0'" + style).paths(), SizeIs(5));
  EXPECT_THAT(read(marker("") + "<rect width='9' height='9'" + style).paths(), SizeIs(1));
}

TEST(Markers, ClipToTheirViewportUnlessToldNotTo) {
  const std::string path = "<path d='M10 20V30' marker-start='url(#m)'/>";
  EXPECT_THAT(read(marker("") + path).clips(), IsEmpty());
  const Reading clipped = read("<marker id='m'><path d='M0 0H1'/></marker>" + path);
  ASSERT_THAT(clipped.clips(), SizeIs(1));
  EXPECT_EQ(to_path_data(clipped.clips()[0]->parts[0].path), "M10 20 L13 20 L13 23 L10 23 Z");
  EXPECT_EQ(clipped.group().clip, clipped.clips()[0]->id);
}

TEST(Markers, ShareTheOpacityOfTheirPath) {
  const Reading reading =
      read(marker("") + "<path d='M10 20V30' opacity='.5' marker-start='url(#m)'/>");
  ASSERT_THAT(reading.groups(), SizeIs(2));
  EXPECT_EQ(reading.groups()[0]->opacity, 0.5);
  EXPECT_EQ(reading.groups()[1]->parent, reading.groups()[0]->id);
  EXPECT_EQ(reading.paths()[0]->parent, reading.groups()[0]->id);
  EXPECT_EQ(reading.paths()[0]->style.opacity, 1);
}

TEST(Markers, InheritFromWhereTheyStand) {
  const Reading reading = read("<g fill='red'>" + marker("") +
                               "</g><path fill='blue' d='M10 20V30' marker-start='url(#m)'/>");
  EXPECT_EQ(reading.paths()[1]->style.fill, Paint(Color{255, 0, 0, 255}));
}

TEST(Markers, AreLeftOutWhereNothingWouldBeSeen) {
  const std::string path = "<path d='M10 20V30' marker-start='url(#m)'/>";
  for (const char* attributes : {"markerWidth='0'", "viewBox='0 0 0 5'"}) {
    EXPECT_THAT(read(marker(attributes) + path).paths(), SizeIs(1)) << attributes;
  }
  EXPECT_THAT(read(path).paths(), SizeIs(1));
}

TEST(Markers, StopReadingTheirAttributesAtAWrongOne) {
  EXPECT_EQ(first_marker("markerUnits='userSpaceOnUse' markerWidth='-1' orient='90'"),
            "M10 20 L11 20");
  EXPECT_EQ(first_marker("markerUnits='page' orient='90'"), "M10 20 L12 20");
}

TEST(Markers, ArePaintedWhereThePaintOrderSays) {
  const auto drawn = [](const std::string& order) {
    const Reading reading = read(marker("") + "<path d='M10 20V30' stroke='red' paint-order='" +
                                 order + "' marker-start='url(#m)'/>");
    std::string shapes;
    for (const PathRecord* path : reading.paths()) {
      const bool filled = path->style.fill != Paint(NoPaint{});
      shapes += path->id == "tip" ? "markers " : filled ? "fill " : "";
      shapes += path->style.stroke ? "stroke " : "";
    }
    return shapes;
  };
  EXPECT_EQ(drawn("normal"), "fill stroke markers ");
  EXPECT_EQ(drawn("MARKERS"), "markers fill stroke ");
  EXPECT_EQ(drawn("fill markers"), "fill markers stroke ");
  EXPECT_EQ(drawn("stroke markers"), "stroke markers fill ");
  EXPECT_EQ(drawn("fill fill markers"), "fill stroke markers ");
}

TEST(Markers, TakeThePaintsOfTheirPath) {
  const Reading reading = read(
      "<marker id='m'><path d='M0 0H1' fill='context-stroke' stroke='context-fill' "
      "fill-opacity='.1'/></marker><path d='M10 20V30' fill='currentColor' color='red' "
      "stroke='blue' stroke-opacity='.5' marker-start='url(#m)'/>");
  const Style style = reading.paths().at(1)->style;
  EXPECT_EQ(style.fill, Paint(Color{0, 0, 255}));
  EXPECT_EQ(style.fill_opacity, 0.5);
  EXPECT_EQ(style.stroke, Paint(Color{255, 0, 0}));
}

TEST(Markers, DoNotDrawThemselves) {
  const Reading reading = read(
      "<marker id='m'><path d='M0 0H1' marker-end='url(#m)'/></marker>"
      "<path d='M10 20V30' marker-end='url(#m)'/>");
  EXPECT_THAT(reading.paths(), SizeIs(2));
}

TEST(Markers, HideWithTheirPath) {
  const Reading reading =
      read(marker("") + "<path visibility='hidden' d='M10 20V30' marker-start='url(#m)'/>");
  EXPECT_TRUE(reading.group().hidden);
}

TEST(Markers, CountAsElementsThatAreUsed) {
  SvgReadOptions options;
  options.limits.used_elements = 100;
  std::string d = "M0 0";
  for (int i = 0; i < 200; ++i) d += "h1";
  const std::string text = "<svg xmlns='http://www.w3.org/2000/svg'>" + marker("") + "<path d='" +
                           d + "' marker-mid='url(#m)'/></svg>";
  EXPECT_THAT(read_error(text, options), ::testing::HasSubstr("more than 100 elements"));
}

}  // namespace
}  // namespace libstyle::svg
