// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/clip_paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/svg/reading.h"

namespace libstyle::svg {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

// The clip record of this id.
const ClipRecord& clip(const Reading& reading, const std::string& id) {
  for (const Record& record : reading.document.records) {
    const auto* const found = std::get_if<ClipRecord>(&record);
    if (found != nullptr && found->id == id) return *found;
  }
  static const ClipRecord kNone;
  ADD_FAILURE() << "no clip " << id;
  return kNone;
}

constexpr const char* kPath = "<path d='M0 0L10 0L10 10z' clip-path='url(#c)'/>";

TEST(ClipPaths, GatherTheInsideInUserSpace) {
  const Reading reading = read(
      "<clipPath id='c'><rect width='2' height='3'/>"
      "<path d='M0 0L1 1' clip-rule='evenodd'/></clipPath>"
      "<g transform='translate(5 5)'>" +
      std::string(kPath) + "</g>");
  EXPECT_EQ(reading.path().clip, "c");
  const ClipRecord& record = clip(reading, "c");
  ASSERT_EQ(record.parts.size(), 1U);
  EXPECT_EQ(to_path_data(record.parts[0].path), "M5 5 L7 5 L7 8 L5 8 Z M5 5 L6 6");
  EXPECT_EQ(record.parts[0].rule, FillRule::kEvenOdd);
}

TEST(ClipPaths, AreUnitedAndClippedWhereTheySaySo) {
  const Reading reading = read(
      "<g xmlns:curves='urn:libstyle:curves'><clipPath id='d'><circle r='5'/></clipPath>"
      "<clipPath id='c' clip-path='url(#d)' curves:parts='united'><rect width='2' height='3'/>"
      "<path d='M0 0L1 1' clip-rule='evenodd' clip-path='url(#d)'/></clipPath>" +
      std::string(kPath) + "</g>");
  const ClipRecord& record = clip(reading, "c");
  ASSERT_EQ(record.parts.size(), 2U);
  EXPECT_EQ(record.parts[0].rule, FillRule::kNonZero);
  EXPECT_EQ(record.parts[1].rule, FillRule::kEvenOdd);
  EXPECT_EQ(record.clip, "d");
  EXPECT_EQ(record.parts[1].clip, "d");
}

TEST(ClipPaths, ComeBeforeWhatTheyClip) {
  const Reading reading = read(std::string(kPath) + "<clipPath id='c'/>");
  EXPECT_TRUE(std::holds_alternative<ClipRecord>(reading.document.records.at(0)));
  EXPECT_THAT(clip(reading, "c").parts, IsEmpty());
}

TEST(ClipPaths, ScaleToTheBoundingBox) {
  const std::string definition =
      "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='1'/></clipPath>";
  EXPECT_EQ(to_path_data(clip(read(definition + kPath), "c").parts.at(0).path),
            "M0 0 L5 0 L5 10 L0 10 Z");
  const Reading group = read(definition +
                             "<g clip-path='url(#c)' transform='scale(2)'>"
                             "<rect x='10' width='10' height='5'/>"
                             "<g display='none'><rect width='99' height='99'/></g>"
                             "<rect x='20' y='5' width='10' height='5'/></g>");
  EXPECT_EQ(to_path_data(clip(group, group.groups().at(0)->clip).parts.at(0).path),
            "M20 0 L40 0 L40 20 L20 20 Z");
}

TEST(ClipPaths, AreSharedByNeighboursInTheSamePlace) {
  const std::string definition = "<clipPath id='c'><rect width='2' height='3'/></clipPath>";
  const Reading reading = read(definition + kPath + kPath);
  EXPECT_EQ(reading.document.records.size(), 3U);
  const Reading moved = read(definition + kPath + "<g transform='scale(2)'>" + kPath + "</g>");
  EXPECT_EQ(moved.paths().at(1)->clip, "c~2");
}

TEST(ClipPaths, AreNotClippedThemselves) {
  const Reading reading = read(
      "<clipPath id='d'><circle r='5'/></clipPath>"
      "<clipPath id='c' clip-path='url(#d)'>"
      "<rect width='2' height='3' clip-path='url(#d)'/></clipPath>" +
      std::string(kPath));
  EXPECT_EQ(clip(reading, "c").clip, "");
  EXPECT_EQ(clip(reading, "c").parts.at(0).clip, "");
  EXPECT_THAT(reading.warning_texts(),
              testing::ElementsAre(HasSubstr("clip-path on a clipPath is not carried"),
                                   HasSubstr("clip-path within a clipPath is not carried")));
}

TEST(ClipPaths, TransformWithinTheUnitsOfABox) {
  EXPECT_EQ(
      to_path_data(clip(read("<clipPath id='c' clipPathUnits='objectBoundingBox'"
                             " transform='translate(.5)'><rect width='1' height='1'/></clipPath>" +
                             std::string(kPath)),
                        "c")
                       .parts.at(0)
                       .path),
      "M5 0 L15 0 L15 10 L5 10 Z");
}

TEST(ClipPaths, MeasureWhatAUseDraws) {
  const Reading reading = read(
      "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='1' height='1'/></clipPath>"
      "<defs><path id='p' d='M0 0H9V8'/></defs><use href='#p' x='5' clip-path='url(#c)'/>");
  EXPECT_EQ(to_path_data(clip(reading, "c").parts.at(0).path), "M5 0 L14 0 L14 8 L5 8 Z");
}

TEST(ClipPaths, LeaveOutWhatIsHidden) {
  EXPECT_THAT(clip(read("<clipPath id='c'><rect width='2' height='3' display='none'/>"
                        "<rect width='2' height='3' visibility='hidden'/></clipPath>" +
                        std::string(kPath)),
                   "c")
                  .parts,
              IsEmpty());
}

TEST(ClipPaths, DrawWhatUseRefersTo) {
  EXPECT_EQ(to_path_data(clip(read("<defs><path id='p' d='M0 0L1 1'/></defs><clipPath id='c'>"
                                   "<use href='#p' x='5'/></clipPath>" +
                                   std::string(kPath)),
                              "c")
                             .parts.at(0)
                             .path),
            "M5 0 L6 1");
}

TEST(ClipPaths, StandAroundTheViewportOfTheirElement) {
  const Reading reading = read(
      "<clipPath id='c'><circle r='5'/></clipPath>"
      "<svg clip-path='url(#c)' width='10' height='10'><path d='M0 0L1 1'/></svg>");
  ASSERT_EQ(reading.groups().size(), 2U);
  EXPECT_EQ(reading.groups()[0]->clip, "c");
  EXPECT_EQ(to_path_data(clip(reading, reading.groups()[1]->clip).parts.at(0).path),
            "M0 0 L10 0 L10 10 L0 10 Z");
  EXPECT_EQ(reading.groups()[1]->parent, reading.groups()[0]->id);
}

TEST(ClipPaths, OfTheOutermostElementMakeItAGroup) {
  const Reading reading = read_file(
      "<svg clip-path='url(#c)'><clipPath id='c'><circle r='5'/></clipPath><path d='M0 0L1 "
      "1'/></svg>");
  EXPECT_EQ(reading.group().clip, "c");
  EXPECT_EQ(reading.path().parent, reading.group().id);
}

TEST(ClipPaths, AreWarnedAboutWhereTheyLeadNowhere) {
  for (const char* value : {"url(#none)", "url(#r)", "circle(5px)"}) {
    const Reading reading =
        read("<rect id='r' width='1' height='1' clip-path='" + std::string(value) + "'/>");
    EXPECT_EQ(reading.path().clip, "");
    EXPECT_THAT(reading.warning_texts(), testing::ElementsAre(HasSubstr("no clipPath")));
  }
}

TEST(ClipPaths, EndWhereTheyReferToThemselves) {
  const Reading reading = read(
      "<g xmlns:curves='urn:libstyle:curves'><clipPath id='c' clip-path='url(#c)'"
      " curves:parts='united'><rect width='2' height='3' clip-path='url(#c)'/></clipPath>" +
      std::string(kPath) + "</g>");
  EXPECT_EQ(clip(reading, "c").clip, "");
  EXPECT_THAT(reading.warning_texts(), testing::Contains(HasSubstr("refers to itself")));
}

// Every level has two parts, each clipped by the level before at a place of its own.
TEST(ClipPaths, EndInAnErrorWhereTheyMultiplyWithoutEnd) {
  std::string text =
      "<svg xmlns:curves='urn:libstyle:curves'><clipPath id='c0'><rect width='1' "
      "height='1'/></clipPath>";
  for (int i = 1; i <= 30; ++i) {
    const std::string part =
        "<rect width='1' height='1' clip-path='url(#c" + std::to_string(i - 1) + ")'";
    text += "<clipPath curves:parts='united' id='c" + std::to_string(i) + "'>" + part +
            " transform='scale(2)'/>" + part + " transform='translate(1)'/></clipPath>";
  }
  SvgReadOptions options;
  options.limits.used_elements = 10'000;
  EXPECT_THAT(
      read_error(text + "<rect width='9' height='9' clip-path='url(#c30)'/></svg>", options),
      HasSubstr("use draws more than 10000 elements"));
}

TEST(ClipPaths, HoldNoGroups) {
  const Reading reading = read(
      "<defs><g id='u'><rect width='1' height='1'/></g></defs>"
      "<clipPath id='c'><g><rect width='2' height='2'/></g><use href='#u'/>"
      "<rect width='3' height='3'/></clipPath><rect width='9' height='9' clip-path='url(#c)'/>");
  ASSERT_EQ(reading.clips().size(), 1U);
  ASSERT_EQ(reading.clips()[0]->parts.size(), 1U);
  EXPECT_EQ(to_path_data(reading.clips()[0]->parts[0].path), "M0 0 L3 0 L3 3 L0 3 Z");
}

TEST(ClipPaths, MoveWithTheUseTheyAreOn) {
  const Reading reading = read(
      "<clipPath id='c'><rect width='3' height='3'/></clipPath>"
      "<defs><path id='p' d='M0 0H9'/></defs><use href='#p' x='5' clip-path='url(#c)'/>");
  ASSERT_EQ(reading.clips().size(), 1U);
  EXPECT_EQ(to_path_data(reading.clips()[0]->parts.at(0).path), "M5 0 L8 0 L8 3 L5 3 Z");
}

TEST(ClipPaths, InUnitsOfABoxWithoutAreaDoNotClip) {
  const Reading reading = read(
      "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='1' height='1'/></clipPath>"
      "<path d='M0 0H9' stroke='red' clip-path='url(#c)'/>");
  EXPECT_EQ(reading.path().clip, "");
}

}  // namespace
}  // namespace libstyle::svg
