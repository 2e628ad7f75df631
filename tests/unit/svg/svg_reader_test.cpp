// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/svg_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/unit/svg/reading.h"

namespace libstyle::svg {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string ids_of_paths(const Reading& reading) {
  std::string ids;
  for (const PathRecord* const path : reading.paths()) ids += (ids.empty() ? "" : " ") + path->id;
  return ids;
}

// --- The page -----------------------------------------------------------------------------------

TEST(SvgReader, TakesThePageSizeInAnyUnit) {
  const Header header = read_file("<svg width='210mm' height='1in'/>").document.header;
  EXPECT_DOUBLE_EQ(header.width.value(), 210 / 25.4 * 96);
  EXPECT_DOUBLE_EQ(header.height.value(), 96);
  EXPECT_EQ(header.page_width, "210mm");
  EXPECT_EQ(header.page_height, "1in");
}

TEST(SvgReader, TakesAMissingPageSizeFromTheViewBox) {
  const auto size = [](const std::string& attributes) {
    const Header header =
        read_file("<svg viewBox='0 0 100 50' " + attributes + "/>").document.header;
    return std::pair(header.width.value(), header.height.value());
  };
  EXPECT_EQ(size(""), std::pair(100.0, 50.0));
  EXPECT_EQ(size("width='200'"), std::pair(200.0, 100.0));
  EXPECT_EQ(size("height='200'"), std::pair(400.0, 200.0));
  EXPECT_EQ(size("width='100%' height='100%'"), std::pair(100.0, 50.0));
}

TEST(SvgReader, LeavesAPageOfUnknownSizeOpen) {
  EXPECT_FALSE(read_file("<svg><rect width='5' height='5'/></svg>").document.header.width);
}

TEST(SvgReader, LaysTheViewBoxOnThePage) {
  EXPECT_EQ(read_file("<svg width='200' height='100' viewBox='10 20 50 50'>"
                      "<path d='M10 20L60 70'/></svg>")
                .path_data(),
            "M50 0 L150 100");
  EXPECT_EQ(read_file("<svg width='200' height='100' viewBox='10 20 50 50' "
                      "preserveAspectRatio='none'><path d='M10 20L60 70'/></svg>")
                .path_data(),
            "M0 0 L200 100");
}

// --- Shapes -------------------------------------------------------------------------------------

TEST(SvgReader, KeepsTheKindOfShape) {
  const Reading reading = read(
      "<rect width='1' height='1'/><circle r='1'/><ellipse rx='1' ry='2'/><line x2='1'/>"
      "<polyline points='0 0 1 1'/><polygon points='0 0 1 1'/><path d='M0 0H1'/>");
  std::vector<std::string> shapes;
  for (const PathRecord* const path : reading.paths()) shapes.push_back(path->shape);
  EXPECT_THAT(shapes, ElementsAre("rect", "circle", "ellipse", "line", "polyline", "polygon", ""));
}

TEST(SvgReader, ResolvesLengthsAgainstTheViewport) {
  EXPECT_EQ(read_file("<svg width='200' height='100'>"
                      "<rect x='10%' y='10%' width='50%' height='50%'/></svg>")
                .path_data(),
            "M20 10 L120 10 L120 60 L20 60 Z");
  EXPECT_EQ(read_file("<svg width='200' height='100' viewBox='0 0 20 10'>"
                      "<line x2='50%' y2='50%'/></svg>")
                .path_data(),
            "M0 0 L100 50");
}

TEST(SvgReader, TakesGeometryFromStyleSheets) {
  EXPECT_EQ(read("<style>rect{width:2px;height:3px;x:1px}</style><rect width='9'/>").path_data(),
            "M1 0 L3 0 L3 3 L1 3 Z");
}

TEST(SvgReader, DoesNotDrawShapesWithoutSize) {
  EXPECT_THAT(read("<rect width='1'/><circle r='0'/><ellipse rx='0' ry='1'/>").paths(), IsEmpty());
}

TEST(SvgReader, KeepsDots) {
  const Reading reading = read("<path d='M5 5L5 5M9 9z' stroke='red' stroke-linecap='round'/>");
  EXPECT_EQ(reading.path_data(), "M5 5 L5 5 M9 9 Z");
}

TEST(SvgReader, DrawsAPathUpToItsError) {
  const Reading reading = read("<path id='p' d='M0 0L5 5L6 oops'/>");
  EXPECT_EQ(reading.path_data(), "M0 0 L5 5");
  EXPECT_THAT(reading.warning_texts(), ElementsAre(HasSubstr("#p its path data has an error")));
}

// --- Transforms and strokes ---------------------------------------------------------------------

TEST(SvgReader, AppliesTransformsFromTheInsideOut) {
  EXPECT_EQ(read("<g transform='translate(10 20)'><path transform='scale(2)' d='M1 2L3 4'/></g>")
                .path_data(),
            "M12 24 L16 28");
}

TEST(SvgReader, ScalesStrokesWithEvenTransforms) {
  const Style style = read(
                          "<path transform='rotate(30) scale(3 -3)' d='M0 0H1' stroke='red' "
                          "stroke-width='2' stroke-dasharray='1 2 3' stroke-dashoffset='4'/>")
                          .path()
                          .style;
  EXPECT_FALSE(style.stroke_transform);
  EXPECT_NEAR(style.stroke_width, 6, 1e-12);
  EXPECT_NEAR(style.dash_offset, 12, 1e-12);
  ASSERT_EQ(style.dash_array.size(), 6U);
  EXPECT_NEAR(style.dash_array[2], 9, 1e-12);
  EXPECT_NEAR(style.dash_array[5], 9, 1e-12);
}

TEST(SvgReader, KeepsTheSpaceOfAPenThatIsNotRound) {
  const Style style =
      read("<path transform='translate(5 6) scale(2 3)' d='M0 0H1' stroke='red' stroke-width='2'/>")
          .path()
          .style;
  EXPECT_EQ(style.stroke_transform, Transform::scaling(2, 3));
  EXPECT_EQ(style.stroke_width, 2);
}

TEST(SvgReader, ScalesStrokesThatAreNotToScaleAsLibrsvgDoes) {
  EXPECT_EQ(read("<path transform='scale(3)' d='M0 0H1' stroke='red' stroke-width='2' "
                 "vector-effect='non-scaling-stroke'/>")
                .path()
                .style.stroke_width,
            6);
}

TEST(SvgReader, CarriesTheWholeStroke) {
  const Style style =
      read(
          "<path d='M0 0H1' stroke='#010203' stroke-opacity='50%' stroke-linecap='square' "
          "stroke-linejoin='bevel' stroke-miterlimit='7' paint-order='stroke' fill='none' "
          "opacity='.25' fill-rule='evenodd'/>")
          .path()
          .style;
  EXPECT_EQ(style.fill, Paint(NoPaint{}));
  EXPECT_EQ(style.stroke, Paint(Color{1, 2, 3}));
  EXPECT_EQ(style.stroke_opacity, 0.5);
  EXPECT_EQ(style.line_cap, LineCap::kSquare);
  EXPECT_EQ(style.line_join, LineJoin::kBevel);
  EXPECT_EQ(style.miter_limit, 7);
  EXPECT_TRUE(style.stroke_first);
  EXPECT_FALSE(style.crisp_edges);
  EXPECT_EQ(style.opacity, 0.25);
  EXPECT_EQ(style.fill_rule, FillRule::kEvenOdd);
}

// --- Groups -------------------------------------------------------------------------------------

TEST(SvgReader, KnowsCrispEdges) {
  const auto is_crisp = [](const std::string& value) {
    return read("<g shape-rendering='" + value + "'><path d='M0 0H1'/></g>")
        .path()
        .style.crisp_edges;
  };
  EXPECT_TRUE(is_crisp("crispEdges"));
  EXPECT_TRUE(is_crisp("optimizeSpeed"));
  EXPECT_FALSE(is_crisp("geometricPrecision"));
  EXPECT_FALSE(is_crisp("sharp"));
}

TEST(SvgReader, PutsWhatBlendsIntoGroups) {
  const Reading reading = read(
      "<path style='mix-blend-mode: Multiply' d='M0 0H1'/><g style='isolation:isolate'>"
      "<path style='mix-blend-mode:tint' d='M0 0H1'/></g>");
  ASSERT_THAT(reading.groups(), SizeIs(2));
  EXPECT_EQ(reading.groups()[0]->blend_mode, BlendMode::kMultiply);
  EXPECT_EQ(reading.paths()[0]->parent, reading.groups()[0]->id);
  EXPECT_TRUE(reading.groups()[1]->isolated);
  EXPECT_EQ(reading.groups()[1]->blend_mode, BlendMode::kNormal);
}

TEST(SvgReader, KeepsGroupsThatCarrySomething) {
  const Reading reading =
      read("<g><g id='a' class=' thin  dark '><g opacity='.5'><path d='M0 0H1'/></g></g></g>");
  ASSERT_EQ(reading.groups().size(), 2U);
  const GroupRecord& outer = *reading.groups()[0];
  const GroupRecord& inner = *reading.groups()[1];
  EXPECT_EQ(outer.id, "a");
  EXPECT_EQ(outer.parent, "");
  EXPECT_EQ(outer.classes, "thin  dark");
  EXPECT_EQ(inner.parent, "a");
  EXPECT_EQ(inner.opacity, 0.5);
  EXPECT_EQ(given_id(inner.id), "");
  EXPECT_EQ(reading.path().parent, inner.id);
}

TEST(SvgReader, KeepsLayersLabelsAndData) {
  const Reading reading = read_file(
      "<svg xmlns:i='http://www.inkscape.org/namespaces/inkscape'><g i:groupmode='layer' "
      "i:label='Sea'><path d='M0 0H1' i:label='wave' data-a='x\"y'/></g></svg>");
  EXPECT_TRUE(reading.group().layer);
  EXPECT_EQ(reading.group().label, "Sea");
  EXPECT_EQ(reading.path().label, "wave");
  EXPECT_THAT(reading.path().extras, ElementsAre(Extra{"data-a", "\"x\\\"y\""}));
}

TEST(SvgReader, KeepsWhatIsHidden) {
  const Reading reading = read(
      "<g display='none'><path d='M0 0H1'/></g><path visibility='hidden' d='M0 0H1'/>"
      "<path display='none' d='M0 0H1'/>");
  EXPECT_TRUE(reading.group().hidden);
  EXPECT_FALSE(reading.paths().at(0)->style.hidden);
  EXPECT_TRUE(reading.paths().at(1)->style.hidden);
  EXPECT_TRUE(reading.paths().at(2)->style.hidden);
}

TEST(SvgReader, NeverDrawsDefinitions) {
  const Reading reading = read(
      "<defs><path d='M0 0H1'/></defs><symbol><path d='M0 0H1'/></symbol><clipPath>"
      "<path d='M0 0H1'/></clipPath><title>x</title><x:y xmlns:x='urn:x'><path d='M0 0H1'/></x:y>");
  EXPECT_THAT(reading.document.records, IsEmpty());
  EXPECT_THAT(reading.warnings, IsEmpty());
}

TEST(SvgReader, KnowsTheLineOfEachRecord) {
  EXPECT_EQ(read_file("<svg>\n<g>\n<path d='M0 0H1'/></g></svg>").path().line, 3U);
}

TEST(SvgReader, DrawsTheFirstOfASwitchThatItCan) {
  EXPECT_EQ(ids_of_paths(read("<switch><path id='a' requiredExtensions='x' d='M0 0H1'/>"
                              "<path id='b' systemLanguage='de' d='M0 0H1'/>"
                              "<path id='c' systemLanguage='fr, en-GB' d='M0 0H1'/>"
                              "<path id='d' d='M0 0H1'/></switch>")),
            "d");
}

// --- use, symbol, nested svg --------------------------------------------------------------------

TEST(SvgReader, DrawsWhatUseRefersTo) {
  const Reading reading = read(
      "<defs><path id='p' d='M0 0L1 0'/></defs>"
      "<use xlink:href='#p' x='5' y='6' transform='scale(2)' fill='red'/>");
  EXPECT_EQ(reading.path_data(), "M10 12 L12 12");
  EXPECT_EQ(reading.path().style.fill, Paint(Color{255, 0, 0}));
}

TEST(SvgReader, GivesEveryUseItsOwnIds) {
  const Reading reading = read(
      "<path id='p' d='M0 0L1 0'/><use href='#p'/><use href='#p'/>"
      "<path id='p' d='M0 0L1 0'/>");
  EXPECT_EQ(ids_of_paths(reading), "p p~2 p~3 p~4");
  for (const PathRecord* const path : reading.paths()) EXPECT_EQ(given_id(path->id), "p");
}

TEST(SvgReader, OpensTheViewportOfASymbol) {
  const Reading reading = read(
      "<symbol id='s' viewBox='0 0 10 10'><path d='M0 0L10 10'/></symbol>"
      "<use href='#s' x='20' y='30' width='50' height='50'/>");
  EXPECT_EQ(reading.path_data(), "M20 30 L70 80");
  EXPECT_THAT(reading.clips(), IsEmpty());
}

TEST(SvgReader, ClipsSymbolsAsLibrsvgDoes) {
  const auto clips = [](const std::string& symbol, const std::string& use) {
    return read("<symbol id='s' " + symbol + "><path d='M0 0L10 10'/></symbol><use href='#s' " +
                use + " x='20' y='30' width='50' height='50'/>");
  };
  const std::string box = "viewBox='0 0 10 10'";
  EXPECT_THAT(clips(box + " overflow='hidden'", "").clips(), IsEmpty());
  EXPECT_THAT(clips("overflow='visible'", "").clips(), IsEmpty());
  for (const Reading& reading :
       {clips(box + " overflow='visible'", ""), clips(box, "overflow='hidden'")}) {
    const ClipRecord& clip = *reading.clips().at(0);
    EXPECT_EQ(to_path_data(clip.parts.at(0).path), "M20 30 L70 30 L70 80 L20 80 Z");
  }
}

TEST(SvgReader, TakesOpacityAndClipOfASymbolForNothing) {
  const Reading reading = read(
      "<symbol id='s' opacity='.5' clip-path='url(#c)'><path d='M0 0L10 10'/></symbol>"
      "<clipPath id='c'/><use href='#s'/>");
  EXPECT_EQ(reading.group().opacity, 1);
  EXPECT_EQ(reading.group().clip, "");
}

TEST(SvgReader, TakesPercentagesInASymbolOfTheViewportAroundIt) {
  const auto width = [](const std::string& view) {
    const Reading reading = read("<symbol id='s' " + view +
                                 "><rect width='50%' height='1'/></symbol>"
                                 "<use href='#s' width='20' height='20'/>");
    return reading.path().path.control_box().width();
  };
  EXPECT_EQ(width(""), 50);
  EXPECT_EQ(width("viewBox='0 0 20 20'"), 10);
}

TEST(SvgReader, DrawsWhatIsInAViewBoxWithoutSizeWhereItIs) {
  EXPECT_EQ(read("<svg x='5' width='50' height='50' viewBox='0 0 0 9'><path d='M1 1H2'/></svg>")
                .path_data(),
            "M1 1 L2 1");
  EXPECT_EQ(
      read_file("<svg width='9' height='9' viewBox='0 0 0 9'><path d='M1 1H2'/></svg>").path_data(),
      "M1 1 L2 1");
}

TEST(SvgReader, TransformsAndClipsTheWholePageAroundItsViewBox) {
  const Reading reading = read_file(
      "<svg width='100' height='100' viewBox='0 0 10 10' transform='translate(7)'"
      " clip-path='url(#c)'><clipPath id='c'><rect width='3' height='3'/></clipPath>"
      "<path d='M1 1H2'/></svg>");
  EXPECT_EQ(reading.path_data(), "M17 10 L27 10");
  EXPECT_EQ(to_path_data(reading.clips().at(0)->parts.at(0).path), "M7 0 L10 0 L10 3 L7 3 Z");
}

TEST(SvgReader, EndsWhereAUseComesToItself) {
  EXPECT_EQ(read("<symbol id='s'><path d='M0 0H1'/><use href='#s' x='5'/></symbol>"
                 "<use href='#s'/>")
                .paths()
                .size(),
            2U);
}

TEST(SvgReader, DrawsSymbolsThatAreHiddenOrMovedAsTheyAre) {
  EXPECT_EQ(
      read("<symbol id='s' display='none' transform='scale(2)'><path d='M0 0L10 10'/></symbol>"
           "<use href='#s'/>")
          .path_data(),
      "M0 0 L10 10");
}

TEST(SvgReader, LeavesOutElementsInError) {
  for (const char* inside : {"<svg viewBox='0 0 9'><path d='M0 0H1'/></svg>",
                             "<svg preserveAspectRatio='middle'><path d='M0 0H1'/></svg>",
                             "<line x1='left' x2='5'/>", "<polygon points='0,0 1,1 2'/>",
                             "<defs><path id='p' d='M0 0H1'/></defs><use href='#p' x='left'/>",
                             "<defs><path id='p' d='M0 0H1'/></defs><use href='#p' width='-1'/>"}) {
    const Reading reading = read(inside);
    EXPECT_THAT(reading.paths(), IsEmpty()) << inside;
    EXPECT_THAT(reading.warnings, SizeIs(1)) << inside;
  }
}

TEST(SvgReader, DrawsNothingOfAPageWithAWrongViewBox) {
  EXPECT_THAT(read_file("<svg viewBox='0 0 9px 9px'><path d='M0 0H1'/></svg>").paths(), IsEmpty());
}

TEST(SvgReader, TakesPaintsFromTheUseThatDrawsAShape) {
  const Style style = read(
                          "<defs><path id='p' d='M0 0H1' fill='context-stroke'/></defs>"
                          "<use href='#p' stroke='#010203'/>")
                          .path()
                          .style;
  EXPECT_EQ(style.fill, Paint(Color{1, 2, 3}));
  EXPECT_EQ(read("<path d='M0 0H1' fill='context-fill'/>").path().style.fill, Paint(NoPaint{}));
}

TEST(SvgReader, OpensTheViewportOfANestedSvg) {
  const Reading reading = read(
      "<svg x='10' y='20' width='20' height='20' viewBox='0 0 10 10' overflow='visible'>"
      "<rect width='100%' height='50%'/></svg>");
  EXPECT_EQ(reading.path_data(), "M10 20 L30 20 L30 30 L10 30 Z");
  EXPECT_THAT(reading.groups(), IsEmpty());
}

TEST(SvgReader, KeepsTheSizeOfTheSvgThatIsUsed) {
  EXPECT_EQ(read("<defs><svg id='s' width='10' height='10' viewBox='0 0 10 10'>"
                 "<path d='M0 0L10 10'/></svg></defs><use href='#s' x='5' width='40' height='40'/>")
                .path_data(),
            "M5 0 L15 10");
}

TEST(SvgReader, DrawsAUseOfItsOwnGroupOnce) {
  EXPECT_THAT(read("<g id='g'><path d='M0 0H1'/><use href='#g' x='5'/></g>").paths(), SizeIs(2));
}

TEST(SvgReader, LeavesOutUsesOfThemselves) {
  for (const char* inside : {"<use id='u' href='#u'/>", "<g id='g'><use href='#g'/></g>",
                             "<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>"}) {
    const Reading reading = read(inside);
    EXPECT_THAT(reading.paths(), IsEmpty());
    EXPECT_THAT(reading.warning_texts(), testing::Contains(HasSubstr("refers to itself")));
  }
}

TEST(SvgReader, WarnsAboutUsesOfNothing) {
  EXPECT_THAT(read("<use id='u' href='#none'/>").warning_texts(),
              ElementsAre("1 #u refers to \"#none\", which is not in the file"));
}

// Twenty levels of ten uses each would draw more than there are atoms in this machine.
TEST(SvgReader, RefusesUsesWithoutEnd) {
  std::string text = "<svg><g id='l0'><path d='M0 0H1'/></g>";
  for (int level = 1; level <= 20; ++level) {
    text += "<g id='l" + std::to_string(level) + "'>";
    for (int i = 0; i < 10; ++i) text += "<use href='#l" + std::to_string(level - 1) + "'/>";
    text += "</g>";
  }
  SvgReadOptions options;
  options.limits.used_elements = 10'000;
  EXPECT_THAT(read_error(text + "</svg>", options),
              HasSubstr("use draws more than 10000 elements"));
}

// What is never drawn takes its time each time it is passed over.
TEST(SvgReader, RefusesUsesOfWhatIsNotDrawnWithoutEnd) {
  std::string text = "<svg><g id='a'>", uses;
  for (int i = 0; i < 200; ++i) text += "<desc/>";
  for (int i = 0; i < 200; ++i) uses += "<use href='#a'/>";
  SvgReadOptions options;
  options.limits.used_elements = 10'000;
  EXPECT_THAT(read_error(text + "</g>" + uses + "</svg>", options),
              HasSubstr("use draws more than 10000 elements"));
  const std::string attribute(1'000'000, ' ');
  EXPECT_THAT(read_error("<svg><path id='a' d='" + attribute + "'/>" + uses + "</svg>", options),
              HasSubstr("use draws more than 10000 elements"));
}

TEST(SvgReader, RefusesUsesThatNestWithoutEnd) {
  std::string text = "<svg><defs><path id='l0' d='M0 0H1'/>";
  for (int level = 1; level <= 5000; ++level) {
    text += "<use id='l" + std::to_string(level) + "' href='#l" + std::to_string(level - 1) + "'/>";
  }
  EXPECT_THAT(read_error(text + "</defs><use href='#l5000'/></svg>"),
              HasSubstr("deeper than 1200 levels"));
}

// --- What is not carried, and hostile numbers ---------------------------------------------------

TEST(SvgReader, SaysWhatItDoesNotCarry) {
  const Reading reading = read_file(
      "<svg>\n<foreignObject id='t'>x</foreignObject>\n<image/>\n<path id='p' mask='url(#m)' "
      "filter='url(#f)' "
      "d='M0 0H1'/>\n<script/>\n<rect width='1' height='1'><animate/></rect></svg>");
  EXPECT_THAT(
      reading.warning_texts(),
      testing::UnorderedElementsAre("2 #t foreignObject is not carried", "3 image is not carried",
                                    "4 #p mask is not carried", "4 #p filter is not carried",
                                    "5 script is not carried", "6 animate is not carried"));
  EXPECT_EQ(reading.paths().size(), 2U);
}

TEST(SvgReader, SaysItOnceForEachElement) {
  EXPECT_EQ(read("<defs><image id='t'/></defs><use href='#t'/><use href='#t'/>").warnings.size(),
            1U);
}

TEST(SvgReader, NeverPassesOnNumbersThatAreNotFinite) {
  const Reading reading = read(
      "<path id='a' d='M0 0 L1e308 1e308' transform='scale(1e10)'/><path id='b' d='M0 0 L1e999 0 "
      "L5 5'/>"
      "<path id='c' d='M0 0 L5 5 L NaN 3'/><rect id='d' width='inf' height='1e308' stroke='red'/>"
      "<g transform='scale(1e200)'><path id='e' transform='scale(1e200)' d='M0 0L1 1'/></g>"
      "<path id='f' d='M0 0H1' stroke='red' stroke-width='1e308' transform='scale(100)'/>"
      "<path id='g' d='M0 0H1' stroke='red' stroke-dasharray='1e308' transform='scale(100)'/>"
      "<svg width='1e308' height='1e308' viewBox='0 0 1e-300 1e-300'><path id='h' d='M0 0L1 "
      "1'/></svg>");
  for (const PathRecord* const path : reading.paths()) {
    for (const Point point : path->path.points()) EXPECT_TRUE(is_finite(point)) << path->id;
    EXPECT_TRUE(std::isfinite(path->style.stroke_width)) << path->id;
    for (const double dash : path->style.dash_array) EXPECT_TRUE(std::isfinite(dash)) << path->id;
  }
  std::set<std::string> warned;
  for (const Warning& warning : reading.warnings) warned.insert(warning.id);
  for (const char* id : {"a", "b", "c", "d", "e"}) EXPECT_TRUE(warned.contains(id)) << id;
}

TEST(SvgReader, RefusesMorePointsThanTheLimit) {
  SvgReadOptions options;
  options.limits.points = 10;
  std::string data = "M0 0";
  for (int i = 0; i < 10; ++i) data += " L1 1";
  EXPECT_THAT(read_error("<svg>\n<path d='" + data + "'/></svg>", options),
              testing::StartsWith("test.svg:2: the paths have more than 10 points"));
}

}  // namespace
}  // namespace libstyle::svg
