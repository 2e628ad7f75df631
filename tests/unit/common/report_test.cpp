// SPDX-License-Identifier: Apache-2.0
#include "converters/common/report.h"

#include <gmock/gmock.h>
#include <simdjson.h>

#include <cmath>

namespace libstyle {
namespace {

TEST(Report, IsAnObjectWithAMessageALine) {
  Report report;
  report.add(Severity::kWarning, {"a.svg", 12}, "rock", "filters are not carried");
  report.add(Severity::kError, {}, "", "out of memory");
  EXPECT_EQ(report.to_json("sample", 1),
            R"({"report":1,"program":"sample","exit":1,"errors":1,"warnings":1,"messages":[
{"severity":"warning","file":"a.svg","line":12,"id":"rock","message":"filters are not carried"},
{"severity":"error","file":null,"line":null,"id":null,"message":"out of memory"}
]}
)");
}

TEST(Report, OfNothingHasNoMessages) {
  EXPECT_EQ(Report().to_json("sample", 0),
            "{\"report\":1,\"program\":\"sample\",\"exit\":0,\"errors\":0,\"warnings\":0,"
            "\"messages\":[\n]}\n");
}

TEST(Report, HasListsBesideItsMessages) {
  Report report;
  report.add_to_list("drawings", JsonObject().text("name", "a\"b").number("scale", 0.5));
  report.add_to_list("drawings",
                     JsonObject().text_or_null("name", "").count("curves", 3).flag("open", true));
  EXPECT_THAT(report.to_json("sample", 0), ::testing::EndsWith(R"("messages":[
],"drawings":[
{"name":"a\"b","scale":0.5},
{"name":null,"curves":3,"open":true}
]}
)"));
}

TEST(JsonObject, NestsAndHasNullForWhatIsNot) {
  const JsonObject inner = JsonObject().number("x", std::nan("")).line("line", 0);
  const JsonObject items[] = {inner, JsonObject()};
  EXPECT_EQ(JsonObject().object("a", inner).list("b", items).list("c", {}).to_json(),
            R"({"a":{"x":null,"line":null},"b":[{"x":null,"line":null},{}],"c":[]})");
}

TEST(Report, IsJsonWhateverFilesAreCalled) {
  for (const std::string name :
       {"caf\xe9.svg", "a\"b\\c\n\x01.svg", "\xff\xfe", "gr\xc3\xbc\xc3\x9f.svg"}) {
    Report report;
    report.add(Severity::kError, {name, 1}, name, name + ": is bad");
    simdjson::dom::parser parser;
    const simdjson::padded_string json(report.to_json("sample", 1));
    EXPECT_EQ(parser.parse(json).error(), simdjson::SUCCESS) << json;
  }
  Report report;
  report.add(Severity::kError, {"caf\xe9.svg"}, "", "is bad");
  EXPECT_NE(report.to_json("sample", 1).find("\"caf\xef\xbf\xbd.svg\""), std::string::npos);
}

}  // namespace
}  // namespace libstyle
