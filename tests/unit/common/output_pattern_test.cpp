// SPDX-License-Identifier: Apache-2.0
#include "converters/common/output_pattern.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "converters/common/command.h"

namespace libstyle {
namespace {

TEST(OutputPattern, PutsInTheNameAndTheNumber) {
  OutputPattern pattern("out/{number}-{name}.png");
  EXPECT_EQ(pattern.next("plan", 1), "out/1-plan.png");
  EXPECT_EQ(pattern.next("tree", 7), "out/7-tree.png");
}

TEST(OutputPattern, WithoutPlaceholderIsAPlainName) {
  OutputPattern pattern("plain.png");
  EXPECT_FALSE(pattern.takes_several());
  EXPECT_EQ(pattern.next("plan", 1), "plain.png");
  EXPECT_EQ(OutputPattern("-").next("plan", 1), "-");
}

TEST(OutputPattern, KnowsNoOtherPlaceholders) {
  EXPECT_THROW(OutputPattern("out/{stem}.png"), UsageError);
  EXPECT_THROW(OutputPattern("out/{name.png"), UsageError);
  EXPECT_TRUE(OutputPattern("out/{name}.png").takes_several());
}

TEST(OutputPattern, KeepsDocumentsWhereThePatternSays) {
  const auto name_for = [](std::string_view name) {
    return OutputPattern("out/{name}").next(name, 1);
  };
  EXPECT_EQ(name_for("../../etc/passwd"), "out/_._.._etc_passwd");
  EXPECT_EQ(name_for(".."), "out/_.");
  EXPECT_EQ(name_for(""), "out/unnamed");
  EXPECT_EQ(name_for(std::string_view("a\0b\nc", 5)), "out/a_b_c");
  EXPECT_EQ(name_for("Übung 1"), "out/Übung 1");
  EXPECT_EQ(OutputPattern("{name}").next("-", 1), "./-");
  EXPECT_EQ(OutputPattern("{name}").next("{number}", 1), "{number}");
}

TEST(OutputPattern, CutsLongNamesBetweenCharacters) {
  std::string name = "x";
  while (name.size() < 300) name += "ü";
  const std::string output = OutputPattern("{name}").next(name, 1);
  EXPECT_EQ(output.size(), 199u);
  EXPECT_EQ(output, name.substr(0, 199));
}

TEST(OutputPattern, NumbersNamesThatComeAgain) {
  OutputPattern pattern("{name}.svg");
  EXPECT_EQ(pattern.next("a", 1), "a.svg");
  EXPECT_EQ(pattern.next("a", 1), "a-2.svg");
  EXPECT_EQ(pattern.next("a-3", 1), "a-3.svg");
  EXPECT_EQ(pattern.next("a", 1), "a-4.svg");
  EXPECT_EQ(pattern.next("a-2", 1), "a-2-2.svg");
  EXPECT_EQ(pattern.next("b", 1), "b.svg");
}

TEST(OutputPattern, NeverGivesAnOutputTwice) {
  OutputPattern pattern("{name}");
  std::set<std::string> outputs;
  const char* const names[] = {"a", "a-2", "a", "a-2-2", "a-2", "a/b", "a_b", "a", ".a", "_a"};
  for (int round = 0; round < 5; ++round) {
    for (const char* name : names)
      EXPECT_TRUE(outputs.insert(pattern.next(name, 1)).second) << name;
  }
}

}  // namespace
}  // namespace libstyle
