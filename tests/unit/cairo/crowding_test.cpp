// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/crowding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "converters/cairo/picture.h"
#include "libstyle/base/error.h"
#include "libstyle/geometry/path_data.h"
#include "tests/support/seeds.h"
#include "tests/unit/cairo/drawing.h"

namespace libstyle {
namespace {

const Box kPage = {{0, 0}, {100, 100}};

double pairs(const Path& path) { return edge_pairs(path, Transform{}, kPage); }

// A line that goes to and fro over the page.
Path scribble(std::size_t lines) {
  RandomValues random(1);
  Path path;
  path.move_to({0, 0});
  for (std::size_t i = 0; i < lines; ++i) {
    path.line_to({random.uniform(0, 100), random.uniform(0, 100)});
  }
  return path;
}

Document page_with(Path path, const Style& style) {
  PathRecord record;
  record.path = std::move(path);
  record.style = style;
  record.line = 7;
  return make_page({record});
}

Style fill_style() {
  Style style;
  style.fill = kBlack;
  return style;
}

TEST(EdgePairs, SquaresTheEdgesOfEachRow) {
  // Ten rows of two sides, and a row of three where each of the others lies.
  EXPECT_EQ(pairs(parse_path_data("M10 10 L90 10 L90 20 L10 20 Z")), 9 + 9 * 4 + 9);
}

TEST(EdgePairs, LeavesOutWhatIsAboveAndBelowThePage) {
  EXPECT_EQ(pairs(parse_path_data("M10 -10 L90 -20 L50 -1")), 0);
  EXPECT_EQ(pairs(parse_path_data("M10 101 L90 200")), 0);
  EXPECT_EQ(pairs(parse_path_data("M10 -1e300 L10 1e300")), 100);
}

TEST(EdgePairs, AreThoseCountedRowByRow) {
  for_each_seed(20, [](std::uint64_t seed) {
    RandomValues random(seed);
    Path path;
    path.move_to({random.uniform(-50, 150), random.uniform(-50, 150)});
    for (int i = 0; i < 30; ++i) {
      path.line_to({random.uniform(-50, 150), random.uniform(-50, 150)});
    }
    double sum = 0;
    for (int row = 0; row < 100; ++row) {
      double count = 0;
      for (std::size_t i = 1; i < path.points().size(); ++i) {
        const auto [low, high] = std::minmax(path.points()[i - 1].y, path.points()[i].y);
        count += low < row + 1 && high >= row;
      }
      sum += count * count;
    }
    EXPECT_EQ(pairs(path), sum);
  });
}

TEST(Crowding, AScribbleOfMillionsOfLinesIsRefusedByItsLine) {
  const Document document = page_with(scribble(2'000'000), fill_style());
  TextSink sink;
  Picture picture(sink, {}, {});
  try {
    picture.add(document, "scribble.curves");
    FAIL() << "drawn";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith("scribble.curves:7: so many lines"));
  }
  EXPECT_EQ(sink.text, "");
}

TEST(Crowding, ManyScribblesCountTogether) {
  Document document = page_with(scribble(2'000), fill_style());
  const double each = pairs(std::get<PathRecord>(document.records[0]).path);
  const auto copies = static_cast<std::size_t>(kMostEdgePairs / each) + 1;
  ASSERT_GT(copies, 1000u);
  // Under a clip that lets nothing through, so that they cost no time here.
  document.records.push_front(clip("nothing", {part("M0 0 Z")}));
  std::get<PathRecord>(document.records[1]).clip = "nothing";
  for (std::size_t i = 1; i < copies; ++i) document.records.push_back(document.records[1]);
  EXPECT_THROW(draw_png(document), Error);
}

TEST(Crowding, VectorPicturesTakeAnyNumber) {
  const Document document = page_with(scribble(400'000), fill_style());
  EXPECT_THROW(draw_png(document), Error);
  TextSink sink;
  Picture picture(sink, {PictureFormat::kSvg, {}, {}}, {});
  picture.add(document);
  picture.finish();
  EXPECT_GT(sink.text.size(), 1'000'000u);
}

TEST(Crowding, AStrokeHasTwoEdges) {
  Style stroke;
  stroke.stroke = kBlack;
  const Path path = scribble(150'000);
  EXPECT_LT(2 * pairs(path), kMostEdgePairs);
  EXPECT_THROW(draw_png(page_with(path, stroke)), Error);
}

TEST(Crowding, ACoastOfAMillionPointsIsFarBelowTheLimit) {
  RandomValues random(2);
  Path path;
  Point at = {50, 50};
  path.move_to(at);
  for (int i = 0; i < 1'000'000; ++i) {
    at += {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
    at = {std::clamp(at.x, 1.0, 99.0), std::clamp(at.y, 1.0, 99.0)};
    path.line_to(at);
  }
  EXPECT_LT(pairs(path), kMostEdgePairs / 10);
}

}  // namespace
}  // namespace libstyle
