// SPDX-License-Identifier: Apache-2.0
// A broken document costs none of the others.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "libstyle/base/error.h"
#include "libstyle/curves/reader.h"
#include "libstyle/curves/writer.h"
#include "tests/support/seeds.h"
#include "tests/unit/curves/any_document.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;

// What comes of a stream: the name of each document and the number of its records, or the line of
// the error in its place.
std::vector<std::string> read_on(const std::string& text, const ReaderLimits& limits = {}) {
  TextSource source(text);
  Reader reader(source, "a", limits);
  std::vector<std::string> outcomes;
  Document document;
  for (bool is_there = true; is_there;) {
    try {
      is_there = reader.read(document);
      if (is_there) {
        outcomes.push_back(document.header.name + " " + std::to_string(document.records.size()));
      }
    } catch (const Error& error) {
      outcomes.push_back("line " + std::to_string(error.place().line));
    }
  }
  return outcomes;
}

std::string header(const std::string& name) { return R"({"curves":1,"name":")" + name + "\"}\n"; }
constexpr const char* kGroup = "{\"type\":\"group\"}\n";

TEST(ReaderAfterAnError, GoesOnAtTheNextHeader) {
  for (const std::string bad : {"x", "{\"type\":\"path\"}", "{\"type\":\"path\"", "{}", "[1]",
                                "{\"type\":\"group\",\"curves\":1}"}) {
    EXPECT_THAT(read_on(header("a") + kGroup + header("b") + kGroup + bad + "\n" + kGroup + kGroup +
                        header("c") + kGroup),
                ElementsAre("a 1", "line 5", "c 1"))
        << bad;
  }
}

TEST(ReaderAfterAnError, SaysOnlyTheFirstOfADocument) {
  EXPECT_THAT(read_on(header("a") + "x\ny\n{}\n[\n" + header("b")), ElementsAre("line 2", "b 0"));
}

TEST(ReaderAfterAnError, ABrokenHeaderIsNoFaultOfTheDocumentBefore) {
  for (const std::string bad :
       {"{\"curves\":2}", "{\"curves\":1,\"na", "{\"curves\":1,\"type\":\"path\"}"}) {
    EXPECT_THAT(read_on(header("a") + kGroup + bad + "\n" + kGroup + header("c")),
                ElementsAre("a 1", "line 3", "c 0"))
        << bad;
  }
}

TEST(ReaderAfterAnError, EveryBrokenDocumentIsAnError) {
  EXPECT_THAT(
      read_on("{\"curves\":2}\n" + header("a") + "x\n{\"curves\":2}\n" + kGroup + header("b")),
      ElementsAre("line 1", "line 3", "line 4", "b 0"));
}

TEST(ReaderAfterAnError, KnowsAHeaderWithItsKeysInAnyOrder) {
  EXPECT_THAT(read_on(header("a") + "x\n {\"name\":\"b\", \"curves\" : 1}\n" + kGroup),
              ElementsAre("line 2", "b 1"));
}

TEST(ReaderAfterAnError, FindsTheFirstHeaderBehindOtherThings) {
  EXPECT_THAT(read_on("hello\n" + std::string(kGroup) + header("a")), ElementsAre("line 1", "a 0"));
}

TEST(ReaderAfterAnError, AnIdThatIsThereTwiceCostsItsDocumentAlone) {
  const std::string record = "{\"type\":\"group\",\"id\":\"g\"}\n";
  EXPECT_THAT(read_on(header("a") + record + record + header("b") + record),
              ElementsAre("line 3", "b 1"));
}

TEST(ReaderAfterAnError, TooManyRecordsCostTheirDocumentAlone) {
  ReaderLimits limits;
  limits.records = 1;
  EXPECT_THAT(read_on(header("a") + kGroup + kGroup + kGroup + header("b") + kGroup, limits),
              ElementsAre("line 3", "b 1"));
}

TEST(ReaderAfterAnError, ALineOverTheLimitEndsTheStream) {
  ReaderLimits limits;
  limits.record_bytes = 40;
  EXPECT_THAT(
      read_on(header("a") + header("b") + std::string(50, ' ') + "\n" + header("c"), limits),
      ElementsAre("a 0", "line 3"));
}

TEST(ReaderAfterAnError, ASourceThatFailsEndsTheStream) {
  class Broken final : public ByteSource {
   public:
    std::size_t read(std::span<char>) override { throw Error("no such luck"); }
  };
  Broken source;
  Reader reader(source, "a");
  Document document;
  EXPECT_THROW(reader.read(document), Error);
  EXPECT_FALSE(reader.read(document));
}

// Any documents, some of which get a line in their midst that is no record.
TEST(ReaderAfterAnError, GivesEveryDocumentThatIsWhole) {
  for_each_seed(200, [](std::uint64_t seed) {
    RandomValues random(seed);
    std::string text;
    std::vector<std::string> expected;
    std::size_t line = 0;
    for (int i = 0; i < 5; ++i) {
      Document document = any_document(seed * 5 + static_cast<std::uint64_t>(i));
      document.header.name = std::to_string(i);
      TextSink sink;
      write_document(sink, document);
      const auto lines = static_cast<std::size_t>(std::ranges::count(sink.text, '\n'));
      expected.push_back(document.header.name + " " + std::to_string(document.records.size()));
      if (random.chance(0.5)) {
        sink.text += "{\"type\":\"path\",\n";
        expected.back() = "line " + std::to_string(line + lines + 1);
        ++line;
      }
      line += lines;
      text += sink.text;
    }
    EXPECT_EQ(read_on(text), expected);
  });
}

}  // namespace
}  // namespace libstyle
