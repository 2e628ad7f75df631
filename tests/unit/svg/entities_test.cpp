// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/entities.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace libstyle::svg {
namespace {

std::string expand(const std::string& declarations, const std::string& body,
                   const EntityLimits& limits = {}) {
  const std::string text = expand_entities("<!DOCTYPE svg [" + declarations + "]>" + body,
                                           "test.svg", limits, [](auto&) {});
  return text.substr(text.find_first_not_of(' '));
}

TEST(Entities, LeavesTextWithoutDeclarationsAlone) {
  const std::string text = "<svg a='&b;'>&c; &lt;</svg>";
  EXPECT_EQ(expand_entities(text, "test.svg", {}, [](auto&) {}), text);
}

TEST(Entities, PutsValuesIntoTextAndAttributes) {
  EXPECT_EQ(expand("<!ENTITY c 'red'><!ENTITY r \"<rect fill='&c;'/>\">", "<svg a='&c;'>&r;</svg>"),
            "<svg a='red'><rect fill='red'/></svg>");
}

TEST(Entities, LeavesCommentsAndCdataAlone) {
  EXPECT_EQ(expand("<!ENTITY c 'red'>", "<svg><!-- &c; --><![CDATA[&c;]]></svg>"),
            "<svg><!-- &c; --><![CDATA[&c;]]></svg>");
}

TEST(Entities, CannotEndTheQuotesTheyStandIn) {
  EXPECT_EQ(expand("<!ENTITY q '\"'>", "<svg a=\"x&q;y\"/>"), "<svg a=\"x&quot;y\"/>");
}

// XML 1.0, appendix D: characters are put in when the entity is declared, and what that gives is
// read where the entity stands.
TEST(Entities, PutsInCharactersWhereTheEntityIsDeclared) {
  EXPECT_EQ(expand("<!ENTITY x 'A&#38;#38;B'>", "<svg>&x;</svg>"), "<svg>A&#38;B</svg>");
  EXPECT_EQ(expand("<!ENTITY x '&#60;g/&#x3e;&#xe9;'>", "<svg>&x;</svg>"), "<svg><g/>\u00e9</svg>");
  EXPECT_EQ(expand("<!ENTITY c 'red'><!ENTITY x '&#38;c;'>", "<svg a='&x;'/>"), "<svg a='red'/>");
  EXPECT_EQ(expand("<!ENTITY q '&#34;'>", "<svg a=\"&q;\"/>"), "<svg a=\"&quot;\"/>");
}

TEST(Entities, LeavesWrongReferencesToCharactersAlone) {
  for (const std::string wrong :
       {"&#;", "&#x;", "&#0;", "&#xD800;", "&#x110000;", "&#-1;", "&#3"}) {
    EXPECT_EQ(expand("<!ENTITY x '" + wrong + "'>", "<svg>&x;</svg>"), "<svg>" + wrong + "</svg>");
  }
}

TEST(Entities, LeavesThoseOfXmlAsTheyAre) {
  EXPECT_EQ(
      expand("<!ENTITY lt '&#38;#60;'><!ENTITY amp '?'><!ENTITY x 'y'>", "<svg>&lt;&amp;</svg>"),
      "<svg>&lt;&amp;</svg>");
}

TEST(Entities, KeepsTheFirstOfTwoDeclarations) {
  EXPECT_EQ(expand("<!ENTITY c 'one'><!ENTITY c 'two'>", "<svg>&c;</svg>"), "<svg>one</svg>");
}

TEST(Entities, PassesOverOtherDeclarations) {
  EXPECT_EQ(expand("<!-- ]> --><!ELEMENT a (b)><!ATTLIST a x CDATA '>'><?p ]?><!ENTITY % p 'q'>"
                   "<!ENTITY c 'red'>",
                   "<svg>&c;</svg>"),
            "<svg>red</svg>");
}

TEST(Entities, KeepsLineNumbers) {
  const std::string text = "<!DOCTYPE svg [\n<!ENTITY c 'a\nb'>\n]>\n<svg>&c;\n</svg>";
  const std::string expanded = expand_entities(text, "test.svg", {}, [](auto&) {});
  EXPECT_EQ(std::ranges::count(expanded.substr(0, expanded.find("<svg>")), '\n'), 4);
  EXPECT_EQ(std::ranges::count(expanded, '\n'), 5);
}

TEST(Entities, RefusesEntitiesThatReferToThemselves) {
  EXPECT_THROW(expand("<!ENTITY a '&b;'><!ENTITY b '&a;'>", "<svg>&a;</svg>"), Error);
}

TEST(Entities, RefusesExpansionsBeyondTheLimit) {
  std::string declarations = "<!ENTITY e0 'ha'>";
  for (int i = 1; i <= 30; ++i) {
    const std::string inner = "&e" + std::to_string(i - 1) + ";";
    declarations += "<!ENTITY e" + std::to_string(i) + " '" + inner + inner + "'>";
  }
  EXPECT_THROW(expand(declarations, "<svg>&e30;</svg>"), Error);
  EXPECT_THROW(expand(declarations, "<svg a='&e30;'/>"), Error);
}

TEST(Entities, RefusesEmptyExpansionsWithoutEnd) {
  std::string declarations = "<!ENTITY e0 ''>";
  for (int i = 1; i <= 30; ++i) {
    const std::string inner = "&e" + std::to_string(i - 1) + ";";
    declarations += "<!ENTITY e" + std::to_string(i) + " '" + inner + inner + "'>";
  }
  EXPECT_THROW(expand(declarations, "<svg>&e30;</svg>"), Error);
}

TEST(Entities, NeverOpensExternalOnesAndSaysSo) {
  int warnings = 0;
  const std::string text =
      expand_entities("<!DOCTYPE svg [<!ENTITY s SYSTEM 'file:///etc/passwd'>]><svg>&s;&s;</svg>",
                      "test.svg", {}, [&](const Warning& warning) {
                        ++warnings;
                        EXPECT_THAT(warning.message, testing::HasSubstr("&s;"));
                      });
  EXPECT_THAT(text, testing::EndsWith("<svg></svg>"));
  EXPECT_EQ(warnings, 1);
}

}  // namespace
}  // namespace libstyle::svg
