// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/json_text.h"

#include <gtest/gtest.h>

namespace libstyle {
namespace {

TEST(JsonText, ComesBackAsItWas) {
  for (const std::string text : {"", "plain", "a \"b\" \\ /", "tab\tline\n\x01", "Übung 😀"}) {
    std::string json;
    append_json_string(json, text);
    EXPECT_EQ(parse_json_string(json), text);
  }
}

TEST(JsonText, ReadsEveryEscape) {
  EXPECT_EQ(parse_json_string(R"("\u00e9\n\/\ud83d\ude00")"), "é\n/😀");
}

TEST(JsonText, IsNothingForOtherValues) {
  for (const char* json : {"", "1", "\"", "\"a", "[\"a\"]", "\"a\" \"b\"", R"("\x")", "null"}) {
    EXPECT_EQ(parse_json_string(json), std::nullopt) << json;
  }
}

}  // namespace
}  // namespace libstyle
