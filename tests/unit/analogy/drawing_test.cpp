// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/drawing.h"

#include <gmock/gmock.h>

#include "libstyle/curves/writer.h"
#include "libstyle/geometry/flatten.h"
#include "libstyle/geometry/path_segments.h"
#include "tests/support/analogy_examples.h"
#include "tests/support/matchers.h"
#include "tests/support/seeds.h"
#include "tests/unit/analogy/wavy_drawing.h"

namespace libstyle {
namespace {

const CurveAnalogy& wavy_style() {
  static const CurveAnalogy style(wavy_pairs(), {});
  return style;
}

Document drawn(Document document, int threads = 1) {
  draw_again(document, wavy_style(), {.threads = threads, .progress = {}, .warn = {}});
  return document;
}

const PathRecord& path_at(const Document& document, std::size_t i) {
  return std::get<PathRecord>(document.records[i]);
}

std::string text_of(const Document& document) {
  TextSink sink;
  write_document(sink, document);
  return sink.text;
}

double distance_to(const Path& path, Point place) {
  double nearest = 1e9;
  for (const FlattenedSubpath& flat : flatten(path, 1e-3)) {
    for (const Point p : flat.polyline.points) nearest = std::min(nearest, distance(p, place));
  }
  return nearest;
}

TEST(DrawAgain, ChangesOnlyTheShapeOfPaths) {
  Document document;
  document.header.name = "plan";
  GroupRecord walls;
  walls.id = "walls";
  document.records.push_back(walls);
  PathRecord wall = path_record("wall", "M0 0 L300 0");
  wall.parent = "walls";
  wall.classes = "outer thick";
  wall.shape = "line";
  wall.style.stroke = Color{200, 0, 0};
  wall.style.stroke_width = 3;
  wall.extras.push_back({"data-height", "\"2.4\""});
  document.records.push_back(wall);
  document.records.push_back(UnknownRecord{R"({"type":"note","text":"hello"})"});
  const Document result = drawn(document);
  const PathRecord& after = path_at(result, 1);
  EXPECT_NE(after.path, wall.path);
  EXPECT_EQ(after.shape, "");
  PathRecord put_back = after;
  put_back.path = wall.path;
  put_back.shape = wall.shape;
  Document same = result;
  same.records[1] = put_back;
  EXPECT_EQ(text_of(same), text_of(document));
}

TEST(DrawAgain, LinesThatMetStillMeet) {
  Document document;
  document.records.push_back(path_record("a", "M0 0 L100.123456 20.1234567"));
  document.records.push_back(
      path_record("b", "M100.123456 20.1234567 C150 0 200 80 250.55555 100.77777"));
  const Document result = drawn(document);
  EXPECT_EQ(path_at(result, 0).path.vertices().back(), (Point{100.123456, 20.1234567}));
  EXPECT_EQ(path_at(result, 1).path.vertices().front(), (Point{100.123456, 20.1234567}));
  EXPECT_EQ(path_at(result, 1).path.vertices().back(), (Point{250.55555, 100.77777}));
}

TEST(DrawAgain, LinesThatEndOnOthersStillMeetThem) {
  Document document;
  document.records.push_back(path_record("wall", "M0 0 L300 0"));
  document.records.push_back(path_record("door", "M110.5 0 L110.5 80"));
  const Document result = drawn(document);
  EXPECT_EQ(path_at(result, 1).path.vertices().front(), (Point{110.5, 0}));
  // About 0.9 px where places are not held.
  EXPECT_LT(distance_to(path_at(result, 0).path, {110.5, 0}), 1e-9);
}

// ---- Several styles -------------------------------------------------------------------------

// The same wave, twice as large.
const CurveAnalogy& large_style() {
  static const CurveAnalogy style(wavy_pairs(), [] {
    CurveAnalogyParameters parameters;
    parameters.scale = 2;
    return parameters;
  }());
  return style;
}

constexpr std::size_t kWavy = 0, kLarge = 1, kStays = StylePlan::kNone;

Document drawn_in(std::vector<std::size_t> style_of_record, Document document,
                  WarningHandler warn = {}) {
  const StylePlan plan = {{{&wavy_style(), "wavy"}, {&large_style(), "large"}},
                          std::move(style_of_record)};
  draw_again(document, plan, {.threads = 2, .progress = {}, .warn = std::move(warn)});
  return document;
}

// A wall, a door that stands on it, and a fence that goes on where the wall ends.
Document garden() {
  Document document;
  document.records.push_back(path_record("wall", "M0 0 L300 0"));
  document.records.push_back(path_record("door", "M110.5 0 L110.5 80"));
  document.records.push_back(path_record("fence", "M300 0 C350 0 420 30 500 90"));
  return document;
}

// Curves from node to node of a net, and some from a node to the middle of a straight one.
struct Net {
  struct Meeting {
    std::size_t record;  // that another curve ends on
    Point place;
  };

  Document document;
  std::vector<Meeting> meetings;

  void add(Point from, Point to, double bulge) {
    PathRecord record;
    const Vector third = (to - from) / 3, side = bulge * Vector{-third.y, third.x};
    record.path.move_to(from);
    record.path.cubic_to(from + third + side, to - third + side, to);
    document.records.emplace_back(record);
  }
};

Net random_net(RandomValues& random) {
  constexpr std::size_t kSide = 10;
  std::vector<Point> nodes;
  for (std::size_t i = 0; i < kSide * kSide; ++i) {
    const Point corner = {static_cast<double>(i % kSide), static_cast<double>(i / kSide)};
    nodes.push_back(90 * corner + Vector{random.uniform(-15, 15), random.uniform(-15, 15)});
  }
  Net net;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool has_right = i % kSide + 1 < kSide, has_below = i + kSide < nodes.size();
    if (has_right) net.add(nodes[i], nodes[i + 1], random.uniform(-0.5, 0.5));
    if (!has_below) continue;
    net.add(nodes[i], nodes[i + kSide], 0);
    if (!has_right || i % 2 == 1) continue;
    const Point middle = lerp(nodes[i], nodes[i + kSide], random.uniform(0.3, 0.7));
    net.meetings.push_back({net.document.records.size() - 1, middle});
    net.add(nodes[i + 1], middle, 0);
  }
  return net;
}

TEST(DrawAgain, EveryJunctionOfTwoHundredCurvesStaysClosed) {
  for_each_seed(3, [&](std::uint64_t seed) {
    RandomValues random(seed);
    const Net net = random_net(random);
    const Document after = drawn(net.document);
    ASSERT_GE(after.records.size(), 200U);
    for (std::size_t i = 0; i < after.records.size(); ++i) {
      const Path &old = path_at(net.document, i).path, &fresh = path_at(after, i).path;
      ASSERT_NE(fresh, old);
      EXPECT_EQ(fresh.points().front(), old.points().front());
      EXPECT_EQ(fresh.points().back(), old.points().back());
    }
    for (const Net::Meeting& meeting : net.meetings) {
      const Path& path = path_at(after, meeting.record).path;
      EXPECT_LT(distance_from(flatten(path, 1e-3)[0].polyline, meeting.place), 1e-9);
    }
  });
}

TEST(DrawAgain, OneStyleForAllIsAsOneStyle) {
  EXPECT_EQ(drawn_in({kWavy, kWavy, kWavy}, garden()), drawn(garden()));
}

TEST(DrawAgain, WhatHasNoStyleStaysAsItIs) {
  const Document result = drawn_in({kStays, kWavy, kStays}, garden());
  EXPECT_EQ(path_at(result, 0), path_at(garden(), 0));
  EXPECT_NE(path_at(result, 1).path, path_at(garden(), 1).path);
  EXPECT_EQ(path_at(result, 2), path_at(garden(), 2));
  EXPECT_EQ(drawn_in({kStays, kStays, kStays}, garden()), garden());
}

TEST(DrawAgain, StylesOfOtherPartsDoNotChangeAPart) {
  const Document wavy = drawn_in({kWavy, kWavy, kWavy}, garden());
  const Document large = drawn_in({kLarge, kLarge, kLarge}, garden());
  for (const std::size_t other : {kLarge, kStays}) {
    EXPECT_EQ(path_at(drawn_in({kWavy, other, other}, garden()), 0), path_at(wavy, 0));
    EXPECT_EQ(path_at(drawn_in({other, kWavy, other}, garden()), 1), path_at(wavy, 1));
    EXPECT_EQ(path_at(drawn_in({other, other, kWavy}, garden()), 2), path_at(wavy, 2));
  }
  EXPECT_EQ(path_at(drawn_in({kWavy, kLarge, kStays}, garden()), 1), path_at(large, 1));
}

TEST(DrawAgain, LinesOfDifferentStylesStillMeet) {
  for (const std::vector<std::size_t>& styles :
       std::vector<std::vector<std::size_t>>{{kLarge, kWavy, kStays}, {kWavy, kStays, kLarge}}) {
    const Document result = drawn_in(styles, garden());
    EXPECT_EQ(path_at(result, 0).path.vertices().back(), (Point{300, 0}));
    EXPECT_EQ(path_at(result, 1).path.vertices().front(), (Point{110.5, 0}));
    EXPECT_EQ(path_at(result, 2).path.vertices().front(), (Point{300, 0}));
    EXPECT_LT(distance_to(path_at(result, 0).path, {110.5, 0}), 0.5);
  }
}

TEST(DrawAgain, EqualCurvesOfDifferentStylesAreEachDrawnInTheirOwn) {
  Document document;
  for (const char* id : {"filling", "outline", "shadow"}) {
    document.records.push_back(path_record(id, "M0 0 C60 -80 140 80 200 0 L100 150 Z"));
  }
  const Document result = drawn_in({kLarge, kWavy, kWavy}, document);
  EXPECT_EQ(path_at(result, 0).path, path_at(drawn_in({kLarge, kLarge, kLarge}, document), 0).path);
  EXPECT_EQ(path_at(result, 1).path, path_at(drawn(document), 1).path);
  EXPECT_EQ(path_at(result, 2).path, path_at(result, 1).path);
}

TEST(DrawAgain, WarnsOfTheStyleThatIsTooLarge) {
  Document document;
  document.records.push_back(path_record("small", "M0 0 L14 0 L14 14 L0 14 Z"));
  document.records.push_back(path_record("large", "M0 0 L900 0"));
  std::vector<std::string> warnings;
  drawn_in({kLarge, kWavy}, document,
           [&](const Warning& warning) { warnings.push_back(warning.message); });
  EXPECT_THAT(warnings, testing::ElementsAre(testing::HasSubstr("large is large")));
}

TEST(DrawAgain, AVariantIsWhatItsSeedDraws) {
  for (const AnalogyMethod method : {AnalogyMethod::kChain, AnalogyMethod::kGreedy}) {
    CurveAnalogyParameters parameters;
    parameters.method = method;
    parameters.samples = 300;
    const CurveAnalogy first(wavy_pairs(), parameters);
    parameters.seed += 2;
    const CurveAnalogy third(wavy_pairs(), parameters);
    Document expected = garden(), variant = garden(), base = garden();
    draw_again(expected, third, {.threads = 1, .progress = {}, .warn = {}});
    draw_again(variant, first, {.threads = 1, .progress = {}, .warn = {}, .variant = 2});
    draw_again(base, first, {.threads = 1, .progress = {}, .warn = {}});
    EXPECT_EQ(variant, expected);
    EXPECT_NE(variant, base);
  }
}

TEST(DrawAgain, EverySubpathStaysASubpathClosedAsBefore) {
  Document document;
  document.records.push_back(path_record(
      "letter", "M0 0 L120 0 L120 90 L0 90 Z M30 30 C30 60 90 60 90 30 Z M200 0 L300 50 M9 9"));
  const Path path = path_at(drawn(document), 0).path;
  std::vector<bool> closed;
  for (const PathCommand command : path.commands()) {
    if (command == PathCommand::kMove) closed.push_back(false);
    if (command == PathCommand::kClose) closed.back() = true;
  }
  EXPECT_THAT(closed, testing::ElementsAre(true, true, false, false));
}

TEST(DrawAgain, CornersOfOutlinesAreVerticesAgain) {
  Document document;
  document.records.push_back(path_record("box", "M10 10 L210 10 L210 130 L10 130 Z"));
  const std::vector<Point> vertices = path_at(drawn(document), 0).path.vertices();
  for (const Point corner : {Point{10, 10}, Point{210, 10}, Point{210, 130}, Point{10, 130}}) {
    EXPECT_THAT(vertices, testing::Contains(corner));
  }
}

TEST(DrawAgain, AFillingAndItsOutlineAreDrawnAlike) {
  Document document;
  document.records.push_back(path_record("filling", "M0 0 L200 0 L100 150 Z"));
  document.records.push_back(path_record("other", "M0 0 L200 0 L100 150"));
  document.records.push_back(path_record("outline", "M0 0 L200 0 L100 150 Z"));
  const Document result = drawn(document);
  EXPECT_EQ(path_at(result, 0).path, path_at(result, 2).path);
  EXPECT_NE(path_at(result, 0).path, path_at(result, 1).path);
}

TEST(DrawAgain, CarriesValuesAlongTheCurve) {
  Document document;
  PathRecord record = path_record("stroke", "M0 0 L100 0 L200 0");
  record.along.channels = {{"width", {1, 5, 1}}};
  record.along.colors = {{0, 0, 0}, {200, 100, 0}, {0, 0, 0}};
  document.records.push_back(record);
  const PathRecord after = path_at(drawn(document), 0);
  const std::vector<Point> vertices = after.path.vertices();
  const std::vector<double>& widths = *after.along.find("width");
  ASSERT_EQ(widths.size(), vertices.size());
  ASSERT_EQ(after.along.colors.size(), vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const double expected = 5 - 4 * std::abs(vertices[i].x - 100) / 100;
    EXPECT_NEAR(widths[i], expected, 0.3);
    EXPECT_NEAR(after.along.colors[i].red, 50 * (widths[i] - 1), 1);
  }
  EXPECT_EQ(widths.front(), 1);
  EXPECT_EQ(widths.back(), 1);
}

TEST(DrawAgain, GivesLinesTheValuesOfTheExample) {
  std::vector<ExamplePair> pairs = wavy_pairs();
  pairs[0].features = {{"width", FeatureKind::kLength}};
  pairs[0].filtered.channels = {{}};
  for (const Point p : pairs[0].filtered.polyline.points) {
    pairs[0].filtered.channels[0].push_back(3 + std::sin(p.x / 9));
  }
  const CurveAnalogy brush(pairs, {});
  Document document;
  PathRecord record = path_record("stroke", "M0 0 L300 0 M5 5 M0 50 L300 50");
  record.along.channels = {{"tilt", {1, 2, 7, 3, 4}}, {"width", {9, 9, 8, 9, 9}}};
  document.records = {record, path_record("plain", "M0 100 L300 100 M9 9"),
                      path_record("dot", "M9 9")};
  draw_again(document, brush, {.threads = 1, .progress = {}, .warn = {}});
  const PathRecord& stroke = path_at(document, 0);
  const std::vector<double>& widths = *stroke.along.find("width");
  ASSERT_EQ(widths.size(), stroke.path.vertex_count());
  ASSERT_EQ(stroke.along.find("tilt")->size(), stroke.path.vertex_count());
  EXPECT_EQ(stroke.along.find("tilt")->front(), 1);
  // What is drawn has the width of the example, and what is not keeps its own.
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const bool stays = stroke.path.vertices()[i] == Point{5, 5};
    EXPECT_NEAR(widths[i], stays ? 8 : 3, stays ? 0 : 1);
  }
  EXPECT_EQ(path_at(document, 1).along.find("width")->size(),
            path_at(document, 1).path.vertex_count());
  EXPECT_TRUE(path_at(document, 2).along.empty());
}

// Two strokes along a line, with a gap.
const CurveAnalogy& dashed_style() {
  static const CurveAnalogy style = [] {
    ExamplePair pair;
    pair.unfiltered = with_length_parameter({{{0, 0}, {200, 0}}, false});
    pair.filtered = with_length_parameter({{{0, 0}, {6, 0}}, false});
    for (double x = 10; x < 195; x += 10) {
      pair.others.push_back(with_length_parameter({{{x, 0}, {x + 6, 0}}, false}));
    }
    return CurveAnalogy({&pair, 1}, {});
  }();
  return style;
}

TEST(DrawAgain, MakesSubpathsOfStrokes) {
  Document document;
  PathRecord line = path_record("line", "M0 0 L300 0");
  line.along.channels = {{"tilt", {0, 300}}};
  document.records.push_back(line);
  draw_again(document, dashed_style(), {.threads = 1, .progress = {}, .warn = {}});
  const PathRecord& after = path_at(document, 0);
  EXPECT_EQ(after.id, "line");
  EXPECT_NEAR(static_cast<double>(subpaths(after.path).size()), 30, 4);
  const std::vector<Point> vertices = after.path.vertices();
  const std::vector<double>& tilts = *after.along.find("tilt");
  ASSERT_EQ(tilts.size(), vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) EXPECT_NEAR(tilts[i], vertices[i].x, 1e-3);
}

TEST(DrawAgain, AreasKeepTheirShapeBelowStrokes) {
  Document document;
  PathRecord both = path_record("both", "M0 0 L100 0 L100 100 L0 100 Z"), area = both;
  both.style.fill = Color{255, 0, 0};
  both.style.stroke = Color{0, 0, 0};
  area.id = "area";
  area.style.fill = Color{255, 0, 0};
  document.records = {both, area, path_record("both~2", "M0 0 L300 0")};
  const Document before = document;
  draw_again(document, dashed_style(), {.threads = 1, .progress = {}, .warn = {}});
  ASSERT_EQ(document.records.size(), 4u);
  EXPECT_EQ(path_at(document, 0).path, both.path);
  EXPECT_EQ(path_at(document, 0).style.stroke, Paint(NoPaint{}));
  EXPECT_EQ(path_at(document, 1).id, "both~3");
  EXPECT_EQ(path_at(document, 1).style.fill, Paint(NoPaint{}));
  EXPECT_EQ(path_at(document, 1).style.stroke, both.style.stroke);
  EXPECT_GT(subpaths(path_at(document, 1).path).size(), 20u);
  EXPECT_EQ(path_at(document, 2), area);
  EXPECT_GT(subpaths(path_at(document, 3).path).size(), 20u);
}

TEST(DrawAgain, FramesAreTheSameOnAnyNumberOfThreads) {
  const auto frames = [](int threads) {
    Document original;
    for (int i = 0; i < 6; ++i) {
      original.records.push_back(path_record("", "M0 0 L300 0 M0 40 C100 90 200 -10 300 40"));
    }
    DrawnWalks walks;
    std::string text;
    for (std::uint64_t frame = 0; frame < 3; ++frame) {
      Document document = original;
      draw_again(document, wavy_style(),
                 {.threads = threads,
                  .progress = {},
                  .warn = {},
                  .variant = frame,
                  .walks = &walks,
                  .coherence = 0.5});
      text += text_of(document);
    }
    return text;
  };
  EXPECT_EQ(frames(1), frames(2));
}

TEST(DrawAgain, CarriesValuesAcrossTheSeamOfAnOutline) {
  // The outline begins in the middle of a side, where it is thinnest.
  Document document;
  PathRecord record = path_record("box", "M100 0 L200 0 L200 100 L0 100 L0 0 Z");
  record.along.channels = {{"width", {1, 2, 3, 3, 2}}};
  document.records.push_back(record);
  const PathRecord after = path_at(drawn(document), 0);
  const std::vector<Point> vertices = after.path.vertices();
  const std::vector<double>& widths = *after.along.find("width");
  ASSERT_EQ(widths.size(), vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i].x < 30 || vertices[i].x > 170 || vertices[i].y > 20) continue;
    EXPECT_NEAR(widths[i], 1 + std::abs(vertices[i].x - 100) / 100, 0.1);
  }
}

TEST(DrawAgain, WritesFewSmoothPieces) {
  Document document;
  document.records.push_back(path_record("line", "M0 0 L400 0"));
  const Path path = path_at(drawn(document), 0).path;
  // 50 crests and troughs; a polyline of the same exactness has over 500 points.
  EXPECT_LT(path.vertex_count(), 160u);
}

TEST(DrawAgain, CurvesTooSmallForAnyStyleStayAsTheyAre) {
  Document document;
  document.records.push_back(path_record("dot", "M5 5 L5 5 Z"));
  document.records.push_back(path_record("speck", "M0 0 C0.1 0 0.1 0.1 0 0.1 Z"));
  document.records.push_back(path_record("point", "M5 5"));
  const Document result = drawn(document);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(path_at(result, i).path, path_at(document, i).path);
  }
}

TEST(DrawAgain, ThreadsDoNotChangeTheResult) {
  Document document;
  for (int i = 0; i < 20; ++i) {
    PathRecord record = path_record("", "M0 0 C100 0 100 100 200 100");
    record.path.transform(Transform::translation({10.0 * i, 0}));
    document.records.push_back(record);
  }
  const std::string one = text_of(drawn(document, 1));
  EXPECT_EQ(text_of(drawn(document, 2)), one);
  EXPECT_EQ(text_of(drawn(document, 7)), one);
}

TEST(DrawAgain, WarnsWhenTheStyleIsTooLarge) {
  Document document;
  document.records.push_back(path_record("small", "M0 0 L8 0 L8 8 L0 8 Z"));
  std::vector<std::string> warnings;
  draw_again(document, wavy_style(),
             {.threads = 1, .progress = {}, .warn = [&](const Warning& warning) {
                warnings.push_back(warning.message);
              }});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], testing::HasSubstr("smaller scale"));
  EXPECT_THAT(warnings[0], testing::HasSubstr("100 %"));
}

TEST(DrawAgain, WarnsOfCurvesThatAreTooLong) {
  Document document;
  document.records.push_back(path_record("endless", "M0 0 L1e12 0"));
  document.records.push_back(path_record("curved", "M0 0 C1e150 0 1e200 5 1e200 1e200"));
  std::vector<std::string> ids;
  const Document before = document;
  draw_again(document, wavy_style(),
             {.threads = 2, .progress = {}, .warn = [&](const Warning& warning) {
                ids.push_back(warning.id);
              }});
  EXPECT_THAT(ids, testing::ElementsAre("endless", "curved"));
  EXPECT_EQ(text_of(document), text_of(before));
}

TEST(DrawAgain, TellsHowFarItIs) {
  Document document;
  for (int i = 0; i < 5; ++i) document.records.push_back(path_record("", "M0 0 L90 0"));
  std::vector<double> told;
  draw_again(document, wavy_style(),
             {.threads = 2, .progress = [&](double done) { told.push_back(done); }, .warn = {}});
  EXPECT_THAT(told, testing::ElementsAre(0.2, 0.4, 0.6, 0.8, 1.0));
}

}  // namespace
}  // namespace libstyle
