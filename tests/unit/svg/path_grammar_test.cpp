// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/path_grammar.h"

#include <gtest/gtest.h>

#include <string>

#include "converters/svg/arc.h"
#include "libstyle/base/random.h"
#include "libstyle/geometry/path_data.h"

namespace libstyle::svg {
namespace {

// The path that is read; text that is no path shows in the failure.
std::string read(std::string_view text) {
  const ParsedPath parsed = parse_path_grammar(text);
  if (parsed.error_at) return "error at " + std::to_string(*parsed.error_at);
  return to_path_data(parsed.path);
}

// What is kept of a path with an error in it, and where the error is.
std::string read_until_error(std::string_view text) {
  const ParsedPath parsed = parse_path_grammar(text);
  if (!parsed.error_at) return "no error";
  return to_path_data(parsed.path) + " | " + std::to_string(*parsed.error_at);
}

TEST(PathGrammar, KeepsWhatIsNormalAlready) {
  const std::string text = to_path_data(parse_path_data("M1 2 L3 4 C5 6 7 8 9 10 Z M11 12 L13 14"));
  EXPECT_EQ(read(text), text);
}

TEST(PathGrammar, ReadsNoPathFromNoText) {
  EXPECT_EQ(read(""), "");
  EXPECT_EQ(read(" \n\t"), "");
}

TEST(PathGrammar, ResolvesRelativeCommands) {
  EXPECT_EQ(read("m10 20 l1 2 h3 v4 c1 1 2 2 3 3 z"),
            read("M10 20L11 22H14V26C15 27 16 28 17 29Z"));
  EXPECT_EQ(read("M10 20 m5 5 l1 1"), read("M10 20M15 25L16 26"));
}

TEST(PathGrammar, RepeatsCommands) {
  EXPECT_EQ(read("M0 0 1 1 2 2"), read("M0 0L1 1L2 2"));
  EXPECT_EQ(read("m1 1 1 1 1 1"), read("M1 1L2 2L3 3"));
  EXPECT_EQ(read("M0 0H1 2 3"), read("M0 0H1H2H3"));
  EXPECT_EQ(read("M0 0Q1 1 2 0 3 1 4 0"), read("M0 0Q1 1 2 0Q3 1 4 0"));
}

TEST(PathGrammar, ReadsNumbersWithoutSeparators) {
  EXPECT_EQ(read("M1.5.5-3e2+4L-.1-.2"), read("M1.5 .5 L-300 4 L-.1 -.2"));
  EXPECT_EQ(read("M 5. 5.L1.,1."), read("M5 5L1 1"));
  EXPECT_EQ(read("M0,0L1 , 2\n,\t3 4"), read("M0 0L1 2L3 4"));
}

TEST(PathGrammar, ReadsArcFlagsWithoutSeparators) {
  EXPECT_EQ(read("M0 0a5 5 0 0110 0"), read("M0 0 a5 5 0 0 1 10 0"));
  EXPECT_EQ(read("M0 0a5 5 0 10.5.5"), read("M0 0 a5 5 0 1 0 .5 .5"));
  EXPECT_EQ(read("M0 0a5,5 0 0,1,10,0 5,5 0 1,0 10,10"),
            read("M0 0 A5 5 0 0 1 10 0 A5 5 0 1 0 20 10"));
}

TEST(PathGrammar, RaisesQuadraticsExactly) {
  EXPECT_EQ(read("M0 0Q3 6 6 0"), read("M0 0C2 4 4 4 6 0"));
}

TEST(PathGrammar, ReflectsTheLastControlPoint) {
  EXPECT_EQ(read("M0 0C1 1 2 3 4 4S7 7 8 8"), read("M0 0C1 1 2 3 4 4C6 5 7 7 8 8"));
  EXPECT_EQ(read("M0 0Q1 2 3 3T7 7T9 9"), read("M0 0Q1 2 3 3Q5 4 7 7Q9 10 9 9"));
}

TEST(PathGrammar, ReflectsOnlyTheSameKindOfCurve) {
  EXPECT_EQ(read("M1 1S2 2 3 3"), read("M1 1C1 1 2 2 3 3"));
  EXPECT_EQ(read("M1 1Q2 2 3 3S5 5 6 6"), read("M1 1Q2 2 3 3C3 3 5 5 6 6"));
  EXPECT_EQ(read("M1 1C2 2 3 3 4 4T6 6"), read("M1 1C2 2 3 3 4 4Q4 4 6 6"));
  EXPECT_EQ(read("M1 1Q2 2 3 3L4 4T6 6"), read("M1 1Q2 2 3 3L4 4Q4 4 6 6"));
}

TEST(PathGrammar, ContinuesAfterCloseFromTheStartOfTheSubpath) {
  EXPECT_EQ(read("M1 1L5 5L9 1ZL3 3"), read("M1 1L5 5L9 1ZM1 1L3 3"));
  EXPECT_EQ(read("M1 1l4 4zl2 2z"), read("M1 1L5 5ZM1 1L3 3Z"));
  EXPECT_EQ(read("M1 1l4 4zm2 2l1 1"), read("M1 1L5 5ZM3 3L4 4"));
  EXPECT_EQ(read("M1 1L2 2ZZ"), read("M1 1L2 2Z"));
}

TEST(PathGrammar, KeepsSubpathsOfLengthZero) {
  EXPECT_EQ(read("M1 1Z"), "M1 1 Z");
  EXPECT_EQ(read("M1 1l0 0"), to_path_data(parse_path_data("M1 1 L1 1")));
  EXPECT_EQ(read("M1 1M2 2"), to_path_data(parse_path_data("M1 1 M2 2")));
}

TEST(PathGrammar, DrawsAnArcThroughItsTop) {
  const ParsedPath parsed = parse_path_grammar("M0 0A10 10 0 0 1 20 0");
  ASSERT_FALSE(parsed.error_at);
  EXPECT_NEAR(parsed.path.vertices()[3].x, 10, 10 * kArcError);
  EXPECT_NEAR(parsed.path.vertices()[3].y, -10, 10 * kArcError);
}

TEST(PathGrammar, KeepsEverythingUpToTheError) {
  EXPECT_EQ(read_until_error("M0 0L1 1L2"), read("M0 0L1 1") + " | 10");
  EXPECT_EQ(read_until_error("M0 0L1 1 2 2 3"), read("M0 0L1 1L2 2") + " | 14");
  EXPECT_EQ(read_until_error("M0 0L1 1X2 2L3 3"), read("M0 0L1 1") + " | 8");
  EXPECT_EQ(read_until_error("M0 0L1 1,L2 2"), read("M0 0L1 1") + " | 9");
  EXPECT_EQ(read_until_error("M0 0L1,,1"), "M0 0 | 7");
  EXPECT_EQ(read_until_error("M0 0L1 1Z5 5"), read("M0 0L1 1Z") + " | 9");
  EXPECT_EQ(read_until_error("M0 0A1 1 0 2 0 5 5"), "M0 0 | 11");
  EXPECT_EQ(read_until_error("M0 0Lnan 1"), "M0 0 | 5");
  EXPECT_EQ(read_until_error("L1 1"), " | 0");
  EXPECT_EQ(read_until_error("M,1 1"), " | 1");
}

TEST(PathGrammar, StopsWhereCoordinatesOverflow) {
  EXPECT_EQ(read_until_error("M1e308 0l1e308 0"), "M1e+308 0 | 14");
  EXPECT_EQ(read_until_error("M0 0L1e999 0"), "M0 0 | 5");
  EXPECT_EQ(read_until_error("M-1e308 0Q1e308 0 0 0"), "M-1e+308 0 | 21");
  EXPECT_EQ(read_until_error("M-1e308 0C0 0 1.7e308 0 -1e308 0S0 0 1 1").substr(0, 9), "M-1e+308 ");
}

// Every prefix of a path is a path with at most one segment less.
TEST(PathGrammar, APrefixGivesAPrefix) {
  const std::string text = "M1 1l2 3h4v5c1 2 3 4 5 6s1 2 3 4q1 2 3 4t5 6a7 8 9 0 1 10 11zm1 1 2 2z";
  const Path full = parse_path_grammar(text).path;
  for (std::size_t length = 0; length < text.size(); ++length) {
    const Path path = parse_path_grammar(text.substr(0, length)).path;
    ASSERT_LE(path.commands().size(), full.commands().size());
    EXPECT_TRUE(std::equal(path.commands().begin(), path.commands().end(), full.commands().begin()))
        << length;
  }
}

// Whatever the text, the result is a path in the normal form with finite points.
TEST(PathGrammar, AlwaysGivesAProperPath) {
  constexpr std::string_view kAlphabet = "MmLlHhVvCcSsQqTtAaZz0123456789 ,.-+e\n";
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const RandomStream random(seed, 0);
    std::string text = "M0 0";
    for (std::uint64_t i = 0; i < 60; ++i) text += kAlphabet[random.below(i, kAlphabet.size())];
    const Path path = parse_path_grammar(text).path;
    EXPECT_EQ(parse_path_data(to_path_data(path)), path) << text;
  }
}

}  // namespace
}  // namespace libstyle::svg
