// SPDX-License-Identifier: Apache-2.0
// What is written is read back the same, and nothing that passes through is lost.
#include <gtest/gtest.h>

#include <algorithm>

#include "libstyle/base/error.h"
#include "libstyle/curves/reader.h"
#include "libstyle/curves/writer.h"
#include "tests/unit/curves/any_document.h"

namespace libstyle {
namespace {

// Gives at most `step` bytes at a time.
class SlowSource final : public ByteSource {
 public:
  SlowSource(std::string_view text, std::size_t step) : source_(text), step_(step) {}
  std::size_t read(std::span<char> buffer) override {
    return source_.read(buffer.first(std::min(step_, buffer.size())));
  }

 private:
  TextSource source_;
  std::size_t step_;
};

std::vector<Document> read_all(ByteSource& source) {
  Reader reader(source, "test.curves");
  std::vector<Document> documents;
  for (Document document; reader.read(document);) documents.push_back(document);
  return documents;
}

std::vector<Document> read_all(std::string_view text) {
  TextSource source(text);
  return read_all(source);
}

std::string passed_through(std::string_view text) { return to_stream(read_all(text)); }

TEST(CurvesRoundTrip, GivesBackEqualDocumentsAndBytes) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const std::vector<Document> documents = {any_document(seed)};
    const std::string text = to_stream(documents);
    const std::vector<Document> read = read_all(text);
    ASSERT_EQ(read, documents) << "seed " << seed << "\n" << text;
    ASSERT_EQ(to_stream(read), text);
  }
}

TEST(CurvesRoundTrip, KeepsTheDocumentsOfAStreamApart) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const std::vector<Document> documents = {any_document(4 * seed), any_document(4 * seed + 1),
                                             any_document(4 * seed + 2)};
    ASSERT_EQ(read_all(to_stream(documents)), documents) << "seed " << seed;
  }
}

TEST(CurvesRoundTrip, DoesNotDependOnHowTheBytesArrive) {
  std::vector<Document> documents;
  for (std::uint64_t seed = 0; seed < 300; ++seed) documents.push_back(any_document(seed));
  const std::string text = to_stream(documents);
  for (const std::size_t step : {1u, 7u, 4096u, 1u << 30}) {
    SlowSource source(text, step);
    ASSERT_EQ(read_all(source), documents) << "step " << step;
  }
}

TEST(CurvesRoundTrip, TakesLinesLongerThanTheBuffer) {
  std::string d = "M0 0";
  while (d.size() < (std::size_t{3} << 20)) d += " L123.456 789.012";
  const std::string text = "{\"curves\":1}\n{\"type\":\"path\",\"d\":\"" + d +
                           "\"}\n{\"type\":\"path\",\"d\":\"M1 1\"}\n";
  SlowSource source(text, 100000);
  EXPECT_EQ(to_stream(read_all(source)), text);
}

TEST(CurvesRoundTrip, LeavesAnUnknownRecordAsItStands) {
  const std::string text =
      "{\"curves\":1}\n{\"id\" : 5, \"type\" :\"star\",\"points\":[1.0, 2e0, \"\\u0041\"]}\n";
  EXPECT_EQ(passed_through(text), text);
}

TEST(CurvesRoundTrip, KeepsUnknownKeysWhereverTheyStand) {
  EXPECT_EQ(passed_through(R"({"new":1.50,"curves":1}
{"data-x":"a b","type":"path","d":"M0 0","stroke-effect":{"kind":["wavy"]},"along":{"by":"hand","tags":[],"ends":["a","b"]}}
{"type":"clip","parts":[{"d":"","feather":2}]}
{"type":"gradient","linear":{"x1":0,"y1":0,"x2":1,"y2":0,"z":0},"stops":[{"offset":0,"stop-color":"#000000","hint":0.5}]}
)"),
            R"({"curves":1,"new":1.50}
{"type":"path","d":"M0 0","along":{"by":"hand","tags":[],"ends":["a","b"]},"data-x":"a b","stroke-effect":{"kind":["wavy"]}}
{"type":"clip","parts":[{"d":"","feather":2}]}
{"type":"gradient","linear":{"x1":0,"y1":0,"x2":1,"y2":0,"z":0},"stops":[{"offset":0,"stop-color":"#000000","hint":0.5}]}
)");
}

TEST(CurvesRoundTrip, TakesKeysInAnyOrderAndSpelling) {
  EXPECT_EQ(
      passed_through("{\"name\":\"\\u00e9\",\"\\u0063urves\":1}\r\n"
                     " { \"d\" : \"M0 0\\nL1 1\" , \"\\u0069d\":\"a\",\"type\":\"path\" } \n"),
      "{\"curves\":1,\"name\":\"é\"}\n{\"type\":\"path\",\"id\":\"a\",\"d\":\"M0 0 L1 1\"}\n");
}

TEST(CurvesRoundTrip, HoldsTheLargestAndTheSmallestNumbers) {
  const std::string text =
      "{\"curves\":1,\"width\":1.7976931348623157e+308}\n"
      "{\"type\":\"path\",\"d\":\"M1e+308 -1e+308 L5e-324 0\",\"along\":{\"t\":[1e+308,5e-324]}}\n";
  EXPECT_EQ(passed_through(text), text);
}

TEST(CurvesRoundTrip, OfAnEmptyStreamIsEmpty) {
  EXPECT_EQ(passed_through(""), "");
  EXPECT_EQ(passed_through("\n\r\n  \n"), "");
}

TEST(CurvesRoundTrip, TakesALastLineWithoutNewline) {
  EXPECT_EQ(passed_through("{\"curves\":1}"), "{\"curves\":1}\n");
  EXPECT_EQ(passed_through("{\"curves\":1}\n{\"type\":\"group\"}"),
            "{\"curves\":1}\n{\"type\":\"group\"}\n");
}

TEST(CurvesRoundTrip, SkipsBlankLinesAndTakesBothLineEnds) {
  EXPECT_EQ(passed_through("\n{\"curves\":1}\r\n\r\n{\"type\":\"group\"}\r\n"),
            "{\"curves\":1}\n{\"type\":\"group\"}\n");
}

TEST(CurvesRoundTrip, PutsTheFocusOfARadialGradientInItsCenter) {
  const std::vector<Document> read = read_all(
      "{\"curves\":1}\n"
      "{\"type\":\"gradient\",\"radial\":{\"cx\":1,\"cy\":2,\"r\":3,\"fy\":4},\"stops\":[]}\n");
  const auto& gradient = std::get<GradientRecord>(read.at(0).records.at(0));
  EXPECT_EQ(std::get<RadialGeometry>(gradient.geometry).focus, (Point{1, 4}));
}

TEST(CurvesReader, KnowsTheLineOfEveryRecord) {
  const std::vector<Document> read =
      read_all("\n{\"curves\":1}\n\n{\"type\":\"group\"}\n{\"type\":\"star\"}\n{\"curves\":1}\n");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].header.line, 2u);
  EXPECT_EQ(std::get<GroupRecord>(read[0].records[0]).line, 4u);
  EXPECT_EQ(std::get<UnknownRecord>(read[0].records[1]).line, 5u);
  EXPECT_EQ(read[1].header.line, 6u);
}

TEST(CurvesWriter, LeavesOutValuesAlongAPathWithoutVertices) {
  PathRecord record;
  record.along.channels.push_back({"width", {}});
  std::string text;
  append_record(text, record);
  EXPECT_EQ(text, "{\"type\":\"path\",\"d\":\"\",\"along\":{}}\n");
}

TEST(CurvesWriter, RefusesTextThatIsNotUtf8) {
  PathRecord record;
  record.label = "caf\xe9";
  std::string text;
  EXPECT_THROW(append_record(text, record), Error);
}

TEST(CurvesWriter, WritesInPiecesAndAllOfIt) {
  class CountingSink final : public ByteSink {
   public:
    void write(std::string_view bytes) override {
      largest = std::max(largest, bytes.size());
      text += bytes;
    }
    std::size_t largest = 0;
    std::string text;
  };
  Document document;
  for (int i = 0; i < 10000; ++i) {
    PathRecord record;
    record.path.move_to({1.5, i * 0.25});
    record.label = std::string(300, 'x');
    document.records.push_back(record);
  }
  CountingSink sink;
  write_document(sink, document);
  EXPECT_LT(sink.largest, std::size_t{2} << 20);
  EXPECT_EQ(read_all(sink.text), std::vector<Document>{document});
}

}  // namespace
}  // namespace libstyle
