// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/xml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace libstyle::svg {
namespace {

const WarningHandler kIgnore = [](const Warning&) {};

// The names of all elements and their attributes in the order of the file.
std::string names(pugi::xml_node element) {
  std::string text = element.name();
  for (const pugi::xml_attribute attribute : element.attributes()) {
    if (!std::string_view(attribute.name()).starts_with("xmlns")) {
      text += std::string(" @") + attribute.name();
    }
  }
  for (const pugi::xml_node child : element.children()) text += " " + names(child);
  return text;
}

std::string names(const std::string& text) {
  return names(XmlFile(text, "test.svg", {}, kIgnore).root());
}

std::string error(const std::string& text, const XmlLimits& limits = {}) {
  try {
    const XmlFile file(text, "test.svg", limits, kIgnore);
  } catch (const Error& fault) {
    return fault.what();
  }
  return "";
}

TEST(Xml, TakesFilesWithoutNamespaceAsSvg) { EXPECT_EQ(names("<svg><rect/></svg>"), "svg rect"); }

TEST(Xml, TakesThePrefixOffSvgElements) {
  EXPECT_EQ(names("<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:rect/></s:svg>"), "svg rect");
  EXPECT_EQ(names("<svg:svg><svg:g/></svg:svg>"), "svg g");
}

TEST(Xml, MarksElementsOfOtherNamespaces) {
  EXPECT_EQ(names("<svg xmlns='http://www.w3.org/2000/svg' xmlns:x='urn:x'><x:rect/>"
                  "<rect xmlns='urn:x'><g/></rect><g/></svg>"),
            "svg foreign:rect foreign:rect foreign:g g");
}

TEST(Xml, GivesKnownAttributesTheirUsualPrefix) {
  EXPECT_EQ(names("<svg xmlns='http://www.w3.org/2000/svg' xmlns:l='http://www.w3.org/1999/xlink'"
                  " xmlns:i='http://www.inkscape.org/namespaces/inkscape'>"
                  "<use l:href='#a' i:label='b'/></svg>"),
            "svg use @xlink:href @inkscape:label");
}

TEST(Xml, ReadsNamespacesFromEntities) {
  EXPECT_EQ(names("<!DOCTYPE svg [<!ENTITY ns 'http://www.w3.org/2000/svg'>]>"
                  "<a:svg xmlns:a='&ns;'><a:g/></a:svg>"),
            "svg g");
}

TEST(Xml, KnowsTheLineOfAnElement) {
  const XmlFile file("<?xml version='1.0'?>\n<svg>\n\n  <svg:rect\n a='b'/></svg>", "test.svg", {},
                     kIgnore);
  EXPECT_EQ(file.place(file.root()).line, 2U);
  EXPECT_EQ(file.place(file.root().child("rect")).line, 4U);
}

TEST(Xml, SaysWhereTextIsNotWellFormed) {
  EXPECT_THAT(error("<svg>\n<rect\n</svg>"), testing::StartsWith("test.svg:3: "));
  EXPECT_THAT(error("<svg>\n<g>\n</svg>"), testing::StartsWith("test.svg:3: "));
  EXPECT_THAT(error("<svg>\n<g>\n"), testing::HasSubstr("cut off"));
  EXPECT_THAT(error("no drawing"), testing::HasSubstr("is no XML"));
  EXPECT_THAT(error(""), testing::HasSubstr("is no XML"));
}

TEST(Xml, RefusesOtherDocuments) {
  EXPECT_THAT(error("<html/>"), testing::HasSubstr("outermost element is html"));
}

TEST(Xml, RefusesEndlessNesting) {
  std::string text = "<svg>";
  for (int i = 0; i < 10'000; ++i) text += "<g>";
  for (int i = 0; i < 10'000; ++i) text += "</g>";
  EXPECT_THAT(error(text + "</svg>"), testing::HasSubstr("nest deeper than 1000"));
}

TEST(Xml, RefusesFilesBeyondTheLimit) {
  XmlLimits limits;
  limits.bytes = 10;
  EXPECT_THAT(error("<svg>      </svg>", limits), testing::HasSubstr("is larger than"));
}

}  // namespace
}  // namespace libstyle::svg
