// SPDX-License-Identifier: Apache-2.0
// Every fault of a stream is an error in one line that names the input, the line and the key.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "libstyle/base/error.h"
#include "libstyle/curves/reader.h"

namespace libstyle {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string failure_of_stream(std::string_view text, const ReaderLimits& limits = {}) {
  TextSource source(text);
  Reader reader(source, "plan.curves", limits);
  Document document;
  try {
    while (reader.read(document)) {
    }
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// The failure of a record on line 2, after its header.
std::string failure(std::string_view record) {
  return failure_of_stream("{\"curves\":1}\n" + std::string(record) + "\n");
}

// A path with one more key.
std::string failure_of_key(const std::string& key, const std::string& json) {
  return failure("{\"type\":\"path\",\"d\":\"M0 0 L1 1\",\"" + key + "\":" + json + "}");
}

TEST(CurvesErrors, NameTheInputAndTheLineInOneLine) {
  for (const char* bad : {"x", "[1]", "{\"type\":\"path\"}", "{\"type\":5}", "{\"a\":\"\x01\"}"}) {
    EXPECT_THAT(failure(bad), AllOf(StartsWith("plan.curves:2: "), Not(HasSubstr("\n")))) << bad;
  }
}

TEST(CurvesErrors, SayWhenALineIsNotJson) {
  EXPECT_THAT(failure("hello"), HasSubstr("not a JSON object"));
  EXPECT_THAT(failure("[1]"), HasSubstr("not a JSON object"));
  EXPECT_THAT(failure("5"), HasSubstr("not a JSON object"));
  EXPECT_THAT(failure("<svg xmlns='x'>"), HasSubstr("not a JSON object"));
  EXPECT_THAT(failure("{\"type\":\"path\""),
              HasSubstr("not JSON: an object or array is not closed"));
  EXPECT_THAT(failure("{\"type\":\"path\",\"d\":\"M0"), HasSubstr("a string is not closed"));
  EXPECT_THAT(failure("{\"type\":\"path\" \"d\":\"\"}"), HasSubstr("not JSON: a comma, colon"));
  EXPECT_THAT(failure("{\"type\":\"path\",\"d\":\"\",}"), HasSubstr("not JSON"));
  EXPECT_THAT(failure("{\"type\":\"path\",\"d\":\"\"} {}"), HasSubstr("something follows"));
  EXPECT_THAT(failure("{\"type\":\"path\",\"d\":\"\"}}"), HasSubstr("not JSON"));
  EXPECT_THAT(failure("{\"type\":\"path\",\"d\":\"M0 0\"x}"), HasSubstr("not JSON"));
  EXPECT_THAT(failure("{type:\"path\"}"), HasSubstr("not JSON"));
  EXPECT_THAT(failure("{\"type\":\"path\",\"id\":\"\\q\",\"d\":\"\"}"), HasSubstr("wrong escape"));
  EXPECT_THAT(failure("{\"type\":\"path\",\"id\":\"a\tb\",\"d\":\"\"}"),
              HasSubstr("a control character inside a string"));
}

TEST(CurvesErrors, SayWhenWhatIsUnknownIsNotJson) {
  EXPECT_THAT(failure("{\"type\":\"star\",\"a\":[1 2]}"), HasSubstr("not JSON"));
  EXPECT_THAT(failure("{\"type\":\"star\",\"a\":nul}"), HasSubstr("not JSON"));
  EXPECT_THAT(failure("{\"type\":\"star\"} {\"type\":\"star\"}"), HasSubstr("not JSON"));
  for (const char* bad : {"[1 2]", "nul", "[1}", "{\"a\"}", "01", "1e999", "\"\\x\"", "[1,]"}) {
    EXPECT_THAT(failure_of_key("data-x", bad), HasSubstr("not JSON")) << bad;
  }
}

TEST(CurvesErrors, SayWhenTextIsNotUtf8) {
  EXPECT_THAT(failure_of_key("id", "\"caf\xe9\""), HasSubstr("not UTF-8"));
  EXPECT_THAT(failure("{\"type\":\"star\",\"a\":\"\xc0\xaf\"}"), HasSubstr("not UTF-8"));
}

TEST(CurvesErrors, SayWhenTheStreamEndsInTheMiddleOfALine) {
  const std::string whole =
      "{\"curves\":1}\n{\"type\":\"path\",\"id\":\"a\",\"d\":\"M0 0 L10 10\"}";
  const std::size_t second_line = whole.find('\n') + 1;
  for (std::size_t size = second_line + 1; size < whole.size(); ++size) {
    EXPECT_THAT(failure_of_stream(whole.substr(0, size)),
                AllOf(StartsWith("plan.curves:2: not JSON"),
                      HasSubstr("; the stream ends in the middle of this line")))
        << size;
  }
  EXPECT_EQ(failure_of_stream(whole), "no error");
  EXPECT_THAT(failure_of_stream("{\"curves\":1}\n{\"type\":\"path\"}"),
              Not(HasSubstr("the stream ends")));
}

TEST(CurvesErrors, SayWhenAHeaderIsMissingOrUnknown) {
  EXPECT_THAT(failure_of_stream("{\"type\":\"group\"}\n"),
              AllOf(StartsWith("plan.curves:1: "), HasSubstr("a record before any header")));
  EXPECT_THAT(failure_of_stream("{\"type\":\"star\"}\n"), HasSubstr("a record before any header"));
  EXPECT_THAT(failure_of_stream("{\"name\":\"x\"}\n"),
              HasSubstr("\"type\" is missing, or \"curves\" if it is a header"));
  EXPECT_THAT(failure_of_stream("{}\n"), HasSubstr("\"type\" is missing"));
  EXPECT_THAT(failure_of_stream("{\"curves\":2}\n"),
              HasSubstr("\"curves\": must be 1, the version this program reads"));
  EXPECT_THAT(failure_of_stream("{\"curves\":\"1\"}\n"), HasSubstr("must be a finite number"));
  EXPECT_THAT(failure_of_stream("{\"curves\":1}\n\n{\"curves\":1.5}\n"),
              AllOf(StartsWith("plan.curves:3: "), HasSubstr("must be 1")));
}

TEST(CurvesErrors, KeepHeadersAndRecordsApart) {
  EXPECT_THAT(failure("{\"type\":\"group\",\"curves\":1}"), HasSubstr("not both"));
  EXPECT_THAT(failure("{\"curves\":1,\"type\":\"star\"}"), HasSubstr("not both"));
  EXPECT_THAT(failure("{\"curves\":1,\"\\u0074ype\":\"star\"}"), HasSubstr("not both"));
  EXPECT_THAT(failure("{\"type\":5,\"d\":\"\"}"), HasSubstr("\"type\" must be a string"));
}

TEST(CurvesErrors, NameAKeyThatIsMissingOrTwiceThere) {
  EXPECT_THAT(failure("{\"type\":\"path\"}"), HasSubstr("\"d\" is missing"));
  EXPECT_THAT(failure("{\"type\":\"constraint\",\"at\":[0,0]}"), HasSubstr("\"curve\" is missing"));
  EXPECT_THAT(
      failure("{\"type\":\"gradient\",\"linear\":{\"x1\":0,\"y1\":0,\"x2\":1},\"stops\":[]}"),
      HasSubstr("\"linear\": \"y2\" is missing"));
  EXPECT_THAT(failure("{\"type\":\"path\",\"d\":\"\",\"d\":\"\"}"),
              HasSubstr("\"d\" is there twice"));
  EXPECT_THAT(failure("{\"type\":\"group\",\"type\":\"path\",\"d\":\"\"}"),
              HasSubstr("\"type\" is there twice"));
  EXPECT_THAT(failure_of_key("along", "{\"t\":[0,1],\"t\":[0,1]}"),
              HasSubstr("\"along\": \"t\" is there twice"));
  EXPECT_THAT(failure_of_key("along", "{\"color\":[\"#000000\",\"#000000\"],\"color\":[]}"),
              HasSubstr("\"along\": \"color\" is there twice"));
}

TEST(CurvesErrors, SayWhatAValueMustBeAndWhatItIs) {
  EXPECT_THAT(failure_of_key("id", "5"), HasSubstr("\"id\": must be a string, not 5"));
  EXPECT_THAT(failure_of_key("label", "null"), HasSubstr("\"label\": must be a string, not null"));
  EXPECT_THAT(failure_of_key("stroke-width", "\"thin\""),
              HasSubstr("\"stroke-width\": must be a finite number from 0 up, not \"thin\""));
  EXPECT_THAT(failure_of_key("stroke-width", "-1"), HasSubstr("from 0 up, not -1"));
  EXPECT_THAT(failure_of_key("opacity", "1.5"), HasSubstr("from 0 to 1, not 1.5"));
  EXPECT_THAT(failure_of_key("opacity", "[1]"), HasSubstr("from 0 to 1, not an array"));
  EXPECT_THAT(failure_of_key("stroke-miterlimit", "0.5"), HasSubstr("from 1 up, not 0.5"));
  EXPECT_THAT(failure_of_key("stroke-dasharray", "3"), HasSubstr("must be an array, not 3"));
  EXPECT_THAT(failure_of_key("stroke-dasharray", "[1,-3]"), HasSubstr("from 0 up, not -3"));
  EXPECT_THAT(failure_of_key("stroke-transform", "[1,0,0]"), HasSubstr("6 numbers, not 3"));
  EXPECT_THAT(failure_of_key("stroke-linecap", "\"flat\""),
              HasSubstr("must be \"butt\", \"round\" or \"square\", not \"flat\""));
  EXPECT_THAT(failure_of_key("fill", "\"red\""),
              HasSubstr("must be \"none\", a color like \"#00aaff\" or \"url(#id)\", not \"red\""));
  EXPECT_THAT(failure_of_key("fill", "\"url(#)\""), HasSubstr("not \"url(#)\""));
  EXPECT_THAT(failure_of_key("fill", "\"#ff000080\""), HasSubstr("a color without alpha"));
  EXPECT_THAT(failure_of_key("fill", "\"#ff00\""), HasSubstr("must be a color"));
  EXPECT_THAT(failure("{\"type\":\"group\",\"layer\":1}"),
              HasSubstr("must be true or false, not 1"));
  EXPECT_THAT(failure("{\"type\":\"clip\",\"parts\":[3]}"), HasSubstr("must be an object, not 3"));
  EXPECT_THAT(failure("{\"type\":\"element\",\"at\":[1]}"),
              HasSubstr("must have 2 numbers, not 1"));
  EXPECT_THAT(failure_of_stream("{\"curves\":1,\"history\":\"x\"}\n"),
              HasSubstr("\"history\": must be an array, not \"x\""));
}

TEST(CurvesErrors, ShortenALongValueBetweenCharacters) {
  std::string value = "\"";
  for (int i = 0; i < 100; ++i) value += "線";
  value += '"';
  const std::string message = failure_of_key("fill", value);
  EXPECT_THAT(message, HasSubstr("線..."));
  EXPECT_LT(message.size(), 200u);
}

TEST(CurvesErrors, RefuseNumbersThatAreNotFinite) {
  for (const char* bad : {"NaN", "Infinity", "-Infinity", "1e999", "-1e999", "nan", "null"}) {
    EXPECT_THAT(failure_of_key("stroke-dashoffset", bad),
                HasSubstr("\"stroke-dashoffset\": must be"))
        << bad;
  }
  EXPECT_THAT(failure("{\"type\":\"path\",\"d\":\"M0 1e999\"}"),
              HasSubstr("\"d\": path data, character 4: a number is missing or too large"));
  EXPECT_THAT(failure_of_key("along", "{\"width\":[1,1e999]}"),
              HasSubstr("too large for a double"));
}

TEST(CurvesErrors, SayWhereThePathDataIsWrong) {
  EXPECT_THAT(failure("{\"type\":\"path\",\"d\":\"M0 0 Q1 1 2 2\"}"),
              HasSubstr("\"d\": path data, character 6: \"Q\" is not one of"));
  EXPECT_THAT(failure("{\"type\":\"clip\",\"parts\":[{\"d\":\"L1 1\"}]}"),
              HasSubstr("\"parts\": \"d\": path data, character 1: a subpath must begin with M"));
}

TEST(CurvesErrors, CompareTheValuesAlongACurveWithItsVertices) {
  EXPECT_THAT(failure_of_key("along", "{\"width\":[1,2,3]}"),
              HasSubstr("\"along\": \"width\" has 3 values for 2 vertices of \"d\""));
  EXPECT_THAT(failure_of_key("along", "{\"color\":[\"#ffffff\"]}"),
              HasSubstr("\"color\" has 1 values for 2 vertices"));
  EXPECT_THAT(failure_of_key("along", "{\"tilt\":[1]}"), HasSubstr("\"tilt\" has 1 values"));
  EXPECT_THAT(failure("{\"type\":\"path\",\"along\":{\"t\":[0,1]},\"d\":\"M0 0 C1 1 2 2 3 3 Z\"}"),
              HasSubstr("no error"));
  EXPECT_THAT(failure_of_key("along", "{\"width\":[1,-2]}"), HasSubstr("a value is negative"));
  EXPECT_THAT(failure_of_key("along", "{\"pressure\":[1,2]}"), HasSubstr("greater than 1"));
  EXPECT_THAT(failure_of_key("along", "{\"width\":3}"),
              HasSubstr("\"along\": \"width\": must be an array with one value for each vertex"));
  EXPECT_THAT(failure_of_key("along", "{\"t\":[]}"), HasSubstr("must be an array with one value"));
  EXPECT_THAT(failure_of_key("along", "{\"color\":[]}"),
              HasSubstr("must be an array with one value"));
  EXPECT_THAT(failure_of_key("along", "{\"t\":[0,\"x\"]}"),
              HasSubstr("must be an array with one value"));
  EXPECT_THAT(failure_of_key("along", "{\"color\":[\"red\",\"blue\"]}"),
              HasSubstr("must be a color"));
  EXPECT_THAT(failure_of_key("along", "[1,2]"), HasSubstr("\"along\": must be an object"));
}

TEST(CurvesErrors, CheckGradients) {
  const std::string linear = "\"linear\":{\"x1\":0,\"y1\":0,\"x2\":1,\"y2\":0}";
  const std::string radial = "\"radial\":{\"cx\":0,\"cy\":0,\"r\":1}";
  const auto gradient = [](const std::string& rest) {
    return failure("{\"type\":\"gradient\"," + rest + "}");
  };
  EXPECT_THAT(gradient("\"stops\":[]"), HasSubstr("either \"linear\" or \"radial\""));
  EXPECT_THAT(gradient(linear + "," + radial + ",\"stops\":[]"),
              HasSubstr("either \"linear\" or \"radial\""));
  EXPECT_THAT(gradient(linear + ",\"stops\":[{\"offset\":0.5,\"stop-color\":\"#000000\"},"
                                "{\"offset\":0.4,\"stop-color\":\"#000000\"}]"),
              HasSubstr("\"stops\": the offsets must not decrease"));
  EXPECT_THAT(gradient(linear + ",\"stops\":[{\"offset\":2,\"stop-color\":\"#000000\"}]"),
              HasSubstr("\"stops\": \"offset\": must be a finite number from 0 to 1, not 2"));
  EXPECT_THAT(gradient("\"radial\":{\"cx\":0,\"cy\":0,\"r\":-1},\"stops\":[]"),
              HasSubstr("\"radial\": \"r\": must be"));
}

TEST(CurvesErrors, NameTheSecondUseOfAnId) {
  EXPECT_THAT(failure_of_stream("{\"curves\":1}\n{\"type\":\"group\",\"id\":\"a\"}\n"
                                "{\"type\":\"path\",\"id\":\"b\",\"d\":\"\"}\n"
                                "{\"type\":\"path\",\"id\":\"a\",\"d\":\"\"}\n"),
              StartsWith("plan.curves:4: \"id\": \"a\" is also the id of line 2"));
  EXPECT_EQ(failure_of_stream("{\"curves\":1}\n{\"type\":\"group\",\"id\":\"a\"}\n"
                              "{\"curves\":1}\n{\"type\":\"group\",\"id\":\"a\"}\n"),
            "no error");
}

TEST(CurvesErrors, StopAtTheLimits) {
  const std::string header = "{\"curves\":1}\n", record = "{\"type\":\"group\"}\n";
  ReaderLimits limits;
  limits.records = 2;
  EXPECT_EQ(failure_of_stream(header + record + record + header + record, limits), "no error");
  EXPECT_THAT(failure_of_stream(header + record + record + record, limits),
              AllOf(StartsWith("plan.curves:4: "), HasSubstr("more than 2 records")));
  limits.record_bytes = 16;
  EXPECT_EQ(failure_of_stream(header + record, limits), "no error");
  EXPECT_THAT(failure_of_stream(header + "{\"type\" :\"group\"}\n", limits),
              AllOf(StartsWith("plan.curves:2: "), HasSubstr("longer than 16 bytes")));
  // A line without end is refused before the memory is.
  class Endless final : public ByteSource {
   public:
    std::size_t read(std::span<char> buffer) override {
      std::ranges::fill(buffer, ' ');
      return buffer.size();
    }
  };
  Endless source;
  limits.record_bytes = 1 << 20;
  Reader reader(source, "endless", limits);
  Document document;
  EXPECT_THROW(reader.read(document), Error);
}

TEST(CurvesErrors, SurviveDeepNesting) {
  constexpr std::size_t kDepth = 100000;
  const std::string deep = std::string(kDepth, '[') + std::string(kDepth, ']');
  EXPECT_THAT(failure_of_key("data-x", deep), HasSubstr("nested too deeply"));
  EXPECT_THAT(failure("{\"type\":\"star\",\"a\":" + deep + "}"), HasSubstr("nested too deeply"));
  EXPECT_THAT(failure_of_key("stroke-dasharray", deep), HasSubstr("must be a finite number"));
  EXPECT_THAT(failure_of_key("along", "{\"x\":" + deep + "}"), HasSubstr("nested too deeply"));
}

}  // namespace
}  // namespace libstyle
