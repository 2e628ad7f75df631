// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/style_document.h"

#include <gmock/gmock.h>

#include "libstyle/analogy/example_document.h"
#include "libstyle/base/error.h"
#include "libstyle/curves/reader.h"
#include "libstyle/curves/writer.h"
#include "tests/support/curves.h"
#include "tests/unit/analogy/wavy_drawing.h"

namespace libstyle {
namespace {

using ::testing::HasSubstr;

// Through text and back.
Document reread(const Document& document) {
  TextSink sink;
  write_document(sink, document);
  TextSource source(sink.text);
  Reader reader(source, "style");
  Document result;
  EXPECT_TRUE(reader.read(result));
  return result;
}

void expect_equal(const std::vector<ExamplePair>& a, const std::vector<ExamplePair>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].filtered, b[i].filtered);
    EXPECT_EQ(a[i].unfiltered, b[i].unfiltered);
    EXPECT_EQ(a[i].same_parameter, b[i].same_parameter);
    EXPECT_EQ(a[i].features, b[i].features);
    EXPECT_EQ(a[i].others, b[i].others);
  }
}

Document document_of(std::initializer_list<std::string_view> paths) {
  Document document;
  for (const std::string_view data : paths) document.records.push_back(path_record("", data));
  return document;
}

TEST(StyleDocument, HoldsThePairsToTheLastDigit) {
  const Document one = document_of({"M0 0 C10 3.3 20 -7 30.1 0.1", "M5 5 L9 9 L9 5 Z"});
  const Document plain = document_of({"M0 1 L30 1", "M4 4 L9 10 L10 4 Z"});
  for (const Document* unfiltered : {static_cast<const Document*>(nullptr), &plain}) {
    const std::vector<ExamplePair> pairs = example_pairs(unfiltered, one);
    expect_equal(style_pairs(reread(style_document(pairs, one))), pairs);
  }
}

TEST(StyleDocument, HoldsWhichPlacesBelongTogether) {
  Document filtered = document_of({"M0 0 L10 5 L20 0"}), unfiltered = document_of({"M0 0 L20 0"});
  std::get<PathRecord>(filtered.records[0]).along.channels = {{"t", {0, 0.3, 1}}};
  std::get<PathRecord>(unfiltered.records[0]).along.channels = {{"t", {0, 1}}};
  const std::vector<ExamplePair> pairs = example_pairs(&unfiltered, filtered);
  ASSERT_TRUE(pairs[0].same_parameter);
  expect_equal(style_pairs(reread(style_document(pairs, filtered))), pairs);
}

TEST(StyleDocument, HoldsWhatGoesAlongTheLines) {
  Document filtered = document_of({"M0 0 C5 9 5 9 10 5 L20 0", "M5 5 L9 9 L9 5 Z"});
  const Color red{255, 0, 0}, blue{0, 0, 200, 100}, green{3, 99, 4};
  for (Record& record : filtered.records) {
    AlongValues& along = std::get<PathRecord>(record).along;
    along.channels = {{"width", {1, 2.5, 3}}, {"pressure", {0.1, 0.2, 1}}};
    along.colors = {red, blue, green};
  }
  const std::vector<ExamplePair> pairs = example_pairs(nullptr, filtered);
  ASSERT_EQ(pairs[1].features.size(), 6u);
  expect_equal(style_pairs(reread(style_document(pairs, filtered))), pairs);
}

TEST(StyleDocument, HoldsWhichStrokesBelongToWhichLine) {
  const Document unfiltered = document_of({"M0 0 L20 0", "M0 50 L20 50"});
  Document filtered = document_of({"M0 1 L9 1", "M0 51 L20 51", "M11 1 L20 1", "M3 2 L8 3"});
  for (Record& record : filtered.records) {
    std::get<PathRecord>(record).along.channels = {{"width", {1, 2.5}}};
  }
  const std::vector<ExamplePair> pairs = example_pairs(&unfiltered, filtered);
  ASSERT_EQ(pairs[0].others.size(), 2u);
  expect_equal(style_pairs(reread(style_document(pairs, filtered))), pairs);
}

TEST(StyleDocument, IsToldApartFromADrawing) {
  const Document drawing = document_of({"M0 0 L10 5"});
  EXPECT_FALSE(is_style_document(drawing));
  EXPECT_TRUE(is_style_document(style_document(example_pairs(nullptr, drawing), drawing)));
}

TEST(StyleDocument, IsPaintedAsTheExample) {
  Document drawing = document_of({"M0 0 L10 5"});
  Style& style = std::get<PathRecord>(drawing.records[0]).style;
  style.stroke = Color{200, 0, 0};
  style.stroke_width = 3;
  const Document kept = style_document(example_pairs(nullptr, drawing), drawing);
  EXPECT_EQ(painted_like(kept), painted_like(drawing));
}

// ---- What is no style --------------------------------------------------------------------------

std::string complaint(const std::string& text) {
  TextSource source(text);
  Reader reader(source, "style");
  Document document;
  try {
    reader.read(document);
    style_pairs(document);
  } catch (const Error& error) {
    return std::to_string(error.place().line) + ": " + error.message();
  }
  return "";
}

TEST(StyleDocument, SaysWhatIsWrongAndWhere) {
  const std::string header = "{\"curves\":1,\"style\":1}\n";
  const auto path = [](const std::string& label, const std::string& data,
                       const std::string& t = "") {
    return R"({"type":"path","label":")" + label + "\"" +
           (t.empty() ? "" : R"(,"along":{"t":)" + t + "}") + R"(,"d":")" + data + "\"}\n";
  };
  const std::string good = path("filtered", "M0 0 L1 1");
  EXPECT_EQ(complaint(header + good), "");
  EXPECT_EQ(complaint(header + "{\"type\":\"group\",\"id\":\"g\"}\n" + good), "");
  EXPECT_THAT(complaint("{\"curves\":1}\n" + good), HasSubstr("is not a style"));
  EXPECT_THAT(complaint("{\"curves\":1,\"style\":2}\n" + good),
              HasSubstr("1: is a style of version 2"));
  EXPECT_THAT(complaint(header), HasSubstr("no path with the label"));
  EXPECT_THAT(complaint(header + path("wavy", "M0 0 L1 1")), HasSubstr("2: a path of a style has"));
  EXPECT_THAT(complaint(header + path("unfiltered", "M0 0 L1 1")), HasSubstr("has the label"));
  EXPECT_THAT(complaint(header + good + path("stroke", "M0 0 L1 1")), HasSubstr("after these two"));
  EXPECT_THAT(complaint(header + good + path("unfiltered", "M0 0 L1 1") +
                        path("stroke", "M0 0 L1 1", "[0,1]")),
              HasSubstr("4: several strokes"));
  EXPECT_THAT(
      complaint(header + good + path("unfiltered", "M0 0 L1 1") + path("unfiltered", "M0 0 L1 1")),
      HasSubstr("4: a path of a style has the label"));
  for (const char* data : {"M0 0 C1 1 2 2 3 3", "M0 0 L1 1 M2 2 L3 3", "M0 0 L1 0 L1 1 Z M0 0"}) {
    EXPECT_THAT(complaint(header + path("filtered", data)), HasSubstr("straight pieces")) << data;
  }
  for (const char* data : {"", "M0 0", "M1 1 L1 1", "M1 1 Z"}) {
    EXPECT_THAT(complaint(header + path("filtered", data)), HasSubstr("has no length")) << data;
  }
  EXPECT_THAT(complaint(header + path("filtered", "M0 0 L1 1", "[1,0]")), HasSubstr("falls"));
  EXPECT_THAT(complaint(header + path("filtered", "M0 0 L1 1 L2 0 Z", "[0,1,2]")),
              HasSubstr("is open"));
  EXPECT_THAT(
      complaint(header + path("filtered", "M0 0 L1 1", "[0,1]") + path("unfiltered", "M0 0 L1 1")),
      HasSubstr("3: \"t\" is along one"));
}

}  // namespace
}  // namespace libstyle
