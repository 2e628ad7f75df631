// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/xml_writer.h"

#include <gtest/gtest.h>

namespace libstyle::svg {
namespace {

TEST(XmlWriter, NestsAndIndents) {
  TextSink sink;
  XmlWriter xml(sink);
  xml.begin("a");
  xml.attribute("x", 0.5);
  xml.begin("b");
  xml.end();
  xml.begin("c");
  xml.text("one\ntwo\n");
  xml.end();
  xml.end();
  xml.finish();
  EXPECT_EQ(sink.text,
            "<a x=\"0.5\">\n"
            "  <b/>\n"
            "  <c>\n"
            "    one\n"
            "    two\n"
            "  </c>\n"
            "</a>\n");
}

std::string attribute_of(std::string_view value) {
  TextSink sink;
  XmlWriter xml(sink);
  xml.begin("a");
  xml.attribute("x", value);
  xml.end();
  xml.finish();
  return sink.text;
}

TEST(XmlWriter, EscapesWhatXmlReadsDifferently) {
  EXPECT_EQ(attribute_of("<&>"), "<a x=\"&lt;&amp;&gt;\"/>\n");
  EXPECT_EQ(attribute_of("\"&\""), "<a x='\"&amp;\"'/>\n");
  EXPECT_EQ(attribute_of("\"'"), "<a x=\"&quot;'\"/>\n");
  EXPECT_EQ(attribute_of("a\tb\nc\rd"), "<a x=\"a&#9;b&#10;c&#13;d\"/>\n");
  EXPECT_EQ(attribute_of("é ~ '"), "<a x=\"é ~ '\"/>\n");
}

TEST(XmlWriter, ReplacesWhatXmlCannotHold) {
  EXPECT_EQ(attribute_of("a\x01z"), "<a x=\"a\xef\xbf\xbdz\"/>\n");
  EXPECT_EQ(attribute_of("a\xef\xbf\xbfz"), "<a x=\"a\xef\xbf\xbdz\"/>\n");
  EXPECT_EQ(attribute_of("\xef\xbc\xa1"), "<a x=\"\xef\xbc\xa1\"/>\n");  // a wide A stays
}

TEST(XmlWriter, DepthCostsALineEach) {
  TextSink sink;
  XmlWriter xml(sink);
  constexpr int kDepth = 10000;
  for (int i = 0; i < kDepth; ++i) xml.begin("g");
  for (int i = 0; i < kDepth; ++i) xml.end();
  xml.finish();
  EXPECT_LT(sink.text.size(), 100u * kDepth);
}

}  // namespace
}  // namespace libstyle::svg
