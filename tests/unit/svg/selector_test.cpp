// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/selector.h"

#include <gtest/gtest.h>

namespace libstyle::svg {
namespace {

constexpr const char* kTree = R"(<svg id="root" class="top">
  <g id="g1" class="a b"><rect id="r1" class="b" x="10-5"/><circle id="c1"/><rect id="r2"/></g>
  <g id="g2" xml:lang="de-at"><g id="g3"><rect id="r3" class="a"/></g></g><path id="p1" title="one two"/>
</svg>)";

// The ids of all elements of the tree that match, in its order.
std::string matching(std::string_view selectors, const char* text = kTree) {
  pugi::xml_document tree;
  tree.load_string(text);
  const auto parsed = parse_selector_list(selectors);
  if (!parsed) return "not understood";
  std::string ids;
  std::size_t steps = 1000;
  for (const pugi::xpath_node found : tree.select_nodes("//*")) {
    for (const Selector& selector : *parsed) {
      if (!matches(selector, found.node(), steps)) continue;
      ids += std::string(ids.empty() ? "" : " ") + found.node().attribute("id").value();
      break;
    }
  }
  return ids;
}

Specificity specificity(std::string_view selector) {
  return parse_selector_list(selector).value().front().specificity;
}

TEST(Selector, MatchesTypesIdsAndClasses) {
  EXPECT_EQ(matching("*"), "root g1 r1 c1 r2 g2 g3 r3 p1");
  EXPECT_EQ(matching("rect"), "r1 r2 r3");
  EXPECT_EQ(matching("#c1"), "c1");
  EXPECT_EQ(matching(".b"), "g1 r1");
  EXPECT_EQ(matching("g.a.b#g1"), "g1");
  EXPECT_EQ(matching("g.c"), "");
}

TEST(Selector, TakesListsApart) { EXPECT_EQ(matching(" circle , path,.top "), "root c1 p1"); }

TEST(Selector, MatchesCombinators) {
  EXPECT_EQ(matching("g rect"), "r1 r2 r3");
  EXPECT_EQ(matching("#g2 rect"), "r3");
  EXPECT_EQ(matching("#g2 > rect"), "");
  EXPECT_EQ(matching("#g2>g>rect"), "r3");
  EXPECT_EQ(matching("rect + circle"), "c1");
  EXPECT_EQ(matching("rect+rect"), "");
  EXPECT_EQ(matching("rect ~ rect"), "r2");
  EXPECT_EQ(matching("svg g g rect"), "r3");
}

TEST(Selector, TriesEveryAncestor) { EXPECT_EQ(matching("svg > g rect"), "r1 r2 r3"); }

TEST(Selector, MatchesAttributes) {
  EXPECT_EQ(matching("[x]"), "r1");
  EXPECT_EQ(matching("[id=r2]"), "r2");
  EXPECT_EQ(matching("[id='r2']"), "r2");
  EXPECT_EQ(matching("[ title ~= \"two\" ]"), "p1");
  EXPECT_EQ(matching("[x|='10']"), "r1");
  EXPECT_EQ(matching("[id^=r]"), "root r1 r2 r3");
  EXPECT_EQ(matching("[id$='1']"), "g1 r1 c1 p1");
  EXPECT_EQ(matching("[title*=' ']"), "p1");
  EXPECT_EQ(matching("[id^='']"), "");
}

TEST(Selector, MatchesPlacesAmongSiblings) {
  EXPECT_EQ(matching("rect:first-child"), "r1 r3");
  EXPECT_EQ(matching("rect:last-child"), "r2 r3");
  EXPECT_EQ(matching("g > :nth-child(2)"), "c1");
  EXPECT_EQ(matching("g > :nth-child(2n+1)"), "r1 r2 g3 r3");
  EXPECT_EQ(matching("g > :nth-child(odd)"), "r1 r2 g3 r3");
  EXPECT_EQ(matching("#g1 > :nth-child(-n+2)"), "r1 c1");
  EXPECT_EQ(matching("#g1 > :nth-last-child(1)"), "r2");
  EXPECT_EQ(matching(":root"), "root");
  EXPECT_EQ(matching(":only-child"), "root g3 r3");
}

TEST(Selector, MatchesPlacesAmongSiblingsOfAType) {
  EXPECT_EQ(matching("#g1 > :first-of-type"), "r1 c1");
  EXPECT_EQ(matching("#g1 > :last-of-type"), "c1 r2");
  EXPECT_EQ(matching("#g1 > :only-of-type"), "c1");
  EXPECT_EQ(matching("rect:nth-of-type(2)"), "r2");
  EXPECT_EQ(matching("rect:nth-last-of-type(n+2)"), "r1");
}

TEST(Selector, MatchesLanguages) {
  EXPECT_EQ(matching(":lang(de)"), "g2 g3 r3");
  EXPECT_EQ(matching("rect:lang('fr', de-AT)"), "r3");
  EXPECT_EQ(matching(":lang(d)"), "");
}

TEST(Selector, MatchesValuesInAnyCaseOnRequest) {
  EXPECT_EQ(matching("[title='ONE two' i]"), "p1");
  EXPECT_EQ(matching("[title='ONE two']"), "");
}

TEST(Selector, MatchesWhatIsNot) {
  EXPECT_EQ(matching("rect:not(.b)"), "r2 r3");
  EXPECT_EQ(matching("rect:not(.b, #r3)"), "r2");
}

TEST(Selector, MatchesLinks) {
  constexpr const char* kLinks = R"(<svg id="root" href="x"><a id="a1" href=""/><a id="a2"/>
    <a id="a3" xlink:href="y"/></svg>)";
  EXPECT_EQ(matching(":link", kLinks), "a1 a3");
  EXPECT_EQ(matching("a:not(:link)", kLinks), "a2");
  EXPECT_EQ(matching("a:visited", kLinks), "");
}

TEST(Selector, NeverMatchesWhatTheReaderDoes) {
  EXPECT_EQ(matching("rect:hover"), "");
  EXPECT_EQ(matching("rect:hover, path"), "p1");
}

TEST(Selector, ResolvesEscapes) { EXPECT_EQ(matching("#\\72 1"), "r1"); }

TEST(Selector, RefusesWhatItDoesNotKnow) {
  for (const char* text :
       {"", ",", "rect,", "> rect", "rect >", "rect::before", ":unknown", "[x", "[x?=1]", ".", "#",
        "rect $", ":lang()", ":last", ":nth-child", ":not(", ":nth-child(x)",
        ":not(:not(:not(:not(:not(:not(:not(:not(:not(a)))))))))"}) {
    EXPECT_EQ(matching(text), "not understood") << text;
  }
}

TEST(Selector, CountsSpecificity) {
  EXPECT_EQ(specificity("*"), (Specificity{0, 0, 0}));
  EXPECT_EQ(specificity("g rect"), (Specificity{0, 0, 2}));
  EXPECT_EQ(specificity("g .a[x]:first-child"), (Specificity{0, 3, 1}));
  EXPECT_EQ(specificity("#a:not(.b)"), (Specificity{1, 1, 0}));
  EXPECT_LT(specificity(".a.b.c g"), specificity("#a"));
}

// Each descendant combinator could try every ancestor again.
TEST(Selector, CountsItsSteps) {
  pugi::xml_document tree;
  tree.load_string(kTree);
  const pugi::xml_node deepest = tree.select_node("//*[@id='r3']").node();
  std::size_t steps_left = 10;
  EXPECT_TRUE(matches(parse_selector_list("svg g rect")->front(), deepest, steps_left));
  EXPECT_EQ(steps_left, 6U);
  steps_left = 0;
  EXPECT_FALSE(matches(parse_selector_list("rect")->front(), deepest, steps_left));
}

}  // namespace
}  // namespace libstyle::svg
