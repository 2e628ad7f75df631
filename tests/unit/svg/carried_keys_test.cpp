// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/carried_keys.h"

#include <gtest/gtest.h>

#include "libstyle/geometry/path_data.h"

namespace libstyle::svg {
namespace {

PathRecord varied_path() {
  PathRecord path;
  path.path = parse_path_data("M0 0 L1 0 L2 0");
  path.shape = "circle";
  path.along.channels = {{"width", {1, 2, 3}}};
  path.along.colors = {{1, 2, 3, 255}, {4, 5, 6, 7}, {8, 9, 10, 255}};
  path.extras = {{"d", "{\"d\":\"\"}"}, {"data-x", "\"kept elsewhere\""}, {"data-n", "5"}};
  return path;
}

TEST(CarriedKeys, AreNothingForAPlainRecord) {
  PathRecord path;
  path.path = parse_path_data("M0 0 L1 0");
  path.id = "a";
  path.shape = "circle";
  path.style.fill = NoPaint{};
  path.extras = {{"data-x", "\"text\""}};
  EXPECT_EQ(carried_keys(path, false), "");
  EXPECT_EQ(carried_keys(path, true), "{\"type\":\"path\",\"shape\":\"circle\"}");
  EXPECT_EQ(carried_keys(GroupRecord{}), "");
  EXPECT_EQ(carried_keys(GradientRecord{}), "");
  EXPECT_EQ(carried_keys(ClipRecord{}), "");
}

TEST(CarriedKeys, BringAPathBack) {
  PathRecord path = varied_path();
  path.extras = {{"x-foo", "{\"d\":\"\"}"}, {"data-n", "5"}};
  PathRecord read;
  read.path = path.path;
  ASSERT_TRUE(restore_carried_keys(carried_keys(path, true), read));
  EXPECT_EQ(read, path);
}

TEST(CarriedKeys, FitOnlyToAsManyVertices) {
  PathRecord edited;
  edited.path = parse_path_data("M0 0 L1 0");
  const PathRecord before = edited;
  EXPECT_FALSE(restore_carried_keys(carried_keys(varied_path(), true), edited));
  EXPECT_EQ(edited, before);
}

TEST(CarriedKeys, RefuseWhatIsNoRecord) {
  PathRecord path;
  path.path = parse_path_data("M0 0 L1 0");
  for (const char* text : {"", "}", "{", "{}", "[1]", "{\"type\":\"group\"}", "{\"type\":\"path\"",
                           "{\"type\":\"path\",\"along\":{\"width\":[1]}}"}) {
    EXPECT_FALSE(restore_carried_keys(text, path)) << text;
  }
}

TEST(CarriedKeys, MakeAnElementOfItsGroup) {
  ElementRecord element;
  element.id = "e";
  element.label = "Leaf";
  element.category = "leaf";
  element.position = Point{1, 2};
  element.extras = {{"weight", "3"}};
  GroupRecord group;
  group.id = "e";
  group.label = "Leaf";
  const std::optional<Record> read = restore_carried_keys(carried_keys(element), group);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, Record(element));
}

TEST(CarriedKeys, BringUnknownKeysBack) {
  GroupRecord group;
  group.id = "g";
  group.opacity = 0.5;
  GroupRecord extended = group;
  extended.extras = {{"note", "[1,2]"}};
  EXPECT_EQ(restore_carried_keys(carried_keys(extended), group), Record(extended));

  GradientRecord gradient, read_gradient;
  gradient.extras = {{"note", "1"}};
  EXPECT_TRUE(restore_carried_keys(carried_keys(gradient), read_gradient));
  EXPECT_EQ(read_gradient, gradient);

  ClipRecord clip, read_clip;
  clip.extras = {{"note", "1"}};
  EXPECT_TRUE(restore_carried_keys(carried_keys(clip), read_clip));
  EXPECT_EQ(read_clip, clip);
}

TEST(CarriedKeys, BringUnknownKeysOfObjectsBack) {
  const std::vector<Extra> extras = {{"note \"x\"", "[1,2]"}, {"t", "0.5"}};
  const std::string carried = carried_extras(extras);
  GradientStop stop;
  LinearGeometry linear;
  RadialGeometry radial;
  ClipPart part;
  EXPECT_TRUE(restore_carried_extras(carried, stop));
  EXPECT_TRUE(restore_carried_extras(carried, linear));
  EXPECT_TRUE(restore_carried_extras(carried, radial));
  EXPECT_TRUE(restore_carried_extras(carried, part));
  EXPECT_EQ(stop.extras, extras);
  EXPECT_EQ(linear.extras, extras);
  EXPECT_EQ(radial.extras, extras);
  EXPECT_EQ(part.extras, extras);
  for (const char* wrong : {"", "{", "note", "{\"note\"}", "{\"a\":1}],\"stops\":[{\"a\":1}"}) {
    EXPECT_FALSE(restore_carried_extras(wrong, stop)) << wrong;
  }
  EXPECT_EQ(carried_extras({}), "");
}

TEST(CarriedId, IsThatOfTheRecordWhereXmlHasAnother) {
  EXPECT_EQ(carried_id("chair", "chair"), "");
  EXPECT_EQ(carried_id("chair~2", "chair-2"), "chair~2");
  EXPECT_EQ(carried_id("chair~2", ""), "chair~2");
  EXPECT_EQ(carried_id("~2", "clip-1"), "~2");
  EXPECT_EQ(carried_id("~2", ""), "");
  EXPECT_EQ(carried_id("", ""), "");
}

TEST(CarriedId, CountsUntilSomebodyGivesAnother) {
  EXPECT_TRUE(fits_carried_id("chair~2", "chair-2"));
  EXPECT_TRUE(fits_carried_id("chair~2", "chair"));
  EXPECT_TRUE(fits_carried_id("chair~2", ""));
  EXPECT_TRUE(fits_carried_id("~2", "clip-1"));
  EXPECT_FALSE(fits_carried_id("chair~2", "throne"));
  EXPECT_FALSE(fits_carried_id("chair~2", "chair-left"));
  EXPECT_FALSE(fits_carried_id("~2", "window"));
}

TEST(CarriedRecords, AreADocument) {
  const auto document = restore_carried_records(
      "\n  {\"curves\":1,\"name\":\"n\"}\n  "
      "{\"type\":\"label\",\"of\":\"a\",\"style\":\"tree\"}\n");
  ASSERT_TRUE(document);
  EXPECT_EQ(document->header.name, "n");
  EXPECT_EQ(document->records.size(), 1u);
  EXPECT_FALSE(restore_carried_records("nonsense"));
  EXPECT_FALSE(restore_carried_records(""));
}

TEST(DataAttribute, IsATextWithANameThatXmlTakes) {
  EXPECT_TRUE(is_data_attribute({"data-x", "\"1\""}));
  EXPECT_TRUE(is_data_attribute({"data-größe_1.b", "\"\""}));
  EXPECT_FALSE(is_data_attribute({"data-", "\"1\""}));
  EXPECT_FALSE(is_data_attribute({"data-a b", "\"1\""}));
  EXPECT_FALSE(is_data_attribute({"data-x=", "\"1\""}));
  EXPECT_FALSE(is_data_attribute({"data-x", "1"}));
  EXPECT_FALSE(is_data_attribute({"x", "\"1\""}));
}

}  // namespace
}  // namespace libstyle::svg
