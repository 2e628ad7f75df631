// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libstyle/base/error.h"
#include "libstyle/curves/nesting.h"
#include "tests/unit/curves/any_document.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

GroupRecord group(std::string id, std::string parent = "") {
  GroupRecord record;
  record.id = std::move(id);
  record.parent = std::move(parent);
  return record;
}

PathRecord path(std::string id, std::string parent = "") {
  PathRecord record;
  record.id = std::move(id);
  record.parent = std::move(parent);
  record.path.move_to({0, 0});
  return record;
}

// The ids of what stays.
std::vector<std::string> kept(Document document, std::string_view selector) {
  keep_selected(document, RecordSelector(selector));
  std::vector<std::string> ids;
  for (const Record& record : document.records) {
    const RecordBase* base = base_of(record);
    ids.push_back(base ? base->id : "unknown");
  }
  return ids;
}

Document house() {
  GroupRecord layer = group("walls");
  layer.layer = true;
  layer.label = "Outer walls";
  PathRecord door = path("door", "walls");
  door.classes = "wood opening";
  PathRecord window = path("window", "walls");
  window.shape = "rect";
  return {{}, {layer, door, group("inner", "walls"), path("brick", "inner"), window, path("sky")}};
}

TEST(RecordSelector, NamesById) { EXPECT_THAT(kept(house(), "#sky"), ElementsAre("sky")); }

TEST(RecordSelector, NamesByClassAsAWholeWord) {
  EXPECT_THAT(kept(house(), ".wood"), ElementsAre("walls", "door"));
  EXPECT_THAT(kept(house(), ".opening"), ElementsAre("walls", "door"));
  EXPECT_THAT(kept(house(), ".woo"), IsEmpty());
  EXPECT_THAT(kept(house(), ".pening"), IsEmpty());
}

TEST(RecordSelector, NamesByElement) {
  EXPECT_THAT(kept(house(), "rect"), ElementsAre("walls", "window"));
  EXPECT_THAT(kept(house(), "path"), ElementsAre("walls", "door", "inner", "brick", "sky"));
}

TEST(RecordSelector, NamesLayersByLabelAndElseById) {
  Document document = house();
  const auto all = kept(document, "layer:Outer walls");
  EXPECT_THAT(all, ElementsAre("walls", "door", "inner", "brick", "window"));
  EXPECT_THAT(kept(document, "layer:walls"), IsEmpty());
  std::get<GroupRecord>(document.records[0]).label.clear();
  EXPECT_EQ(kept(document, "layer:walls"), all);
  EXPECT_THAT(kept(document, "layer:inner"), IsEmpty()) << "a group that is no layer";
}

TEST(RecordSelector, NamesEveryCopyOfWhatWasDrawnAgain) {
  EXPECT_THAT(kept({{}, {path("a"), path("a~2"), path("b~2")}}, "#a"), ElementsAre("a", "a~2"));
}

TEST(RecordSelector, UnitesItsTerms) {
  EXPECT_THAT(kept(house(), "#sky , rect,.wood"), ElementsAre("walls", "door", "window", "sky"));
}

TEST(RecordSelector, RefusesOtherForms) {
  for (const char* text : {"", "#", ".", "#a,", "layer:", "g > path", "rect.wide", "[id]", "a:b"}) {
    EXPECT_THROW(RecordSelector{text}, Error) << text;
  }
}

TEST(RecordSelector, BareWordsNameWhateverIsCalledSoIfAsked) {
  const auto names = [](const Document& document, std::string_view text) {
    std::vector<std::string> ids;
    for (const Record& record : document.records) {
      if (RecordSelector(text, BareWord::kAnything).matches(record)) {
        ids.push_back(base_of(record)->id);
      }
    }
    return ids;
  };
  EXPECT_THAT(names(house(), "sky"), ElementsAre("sky"));
  EXPECT_THAT(names(house(), "wood"), ElementsAre("door"));
  EXPECT_THAT(names(house(), "rect"), ElementsAre("window"));
  EXPECT_THAT(names(house(), "Outer walls"), ElementsAre("walls"));
  EXPECT_THAT(names(house(), "Outer"), IsEmpty());
  EXPECT_THAT(names(house(), "sky, wood"), ElementsAre("door", "sky"));
  EXPECT_THAT(names(house(), ".sky"), IsEmpty()) << "a mark says what is meant";
  for (const char* text : {"", "rect.wide", "g > path", "[id]", "a:b"}) {
    EXPECT_THROW(RecordSelector(text, BareWord::kAnything), Error) << text;
  }
}

// The terms that select the records of the house; "-" for none.
std::vector<std::string> selectors_of_house(const std::vector<std::string>& texts) {
  std::vector<RecordSelector> selectors;
  for (const std::string& text : texts) selectors.emplace_back(text);
  std::vector<std::string> result;
  for (const std::size_t place : selected_by(house(), selectors)) {
    result.push_back(place == kNotSelected ? "-" : texts[place]);
  }
  return result;
}

// The house: walls (door, inner (brick), window), sky.
TEST(SelectedBy, TheInnermostNameWins) {
  EXPECT_THAT(selectors_of_house({"#door", "#inner", "#walls"}),
              ElementsAre("#walls", "#door", "#inner", "#inner", "#walls", "-"));
  EXPECT_THAT(selectors_of_house({"#walls", "#inner", "#door"}),
              ElementsAre("#walls", "#door", "#inner", "#inner", "#walls", "-"));
}

TEST(SelectedBy, OfTwoThatNameTheSameTheLastWins) {
  EXPECT_THAT(selectors_of_house({"#door", ".wood"}),
              ElementsAre("-", ".wood", "-", "-", "-", "-"));
  EXPECT_THAT(selectors_of_house({".wood", "#door"}),
              ElementsAre("-", "#door", "-", "-", "-", "-"));
}

TEST(SelectedBy, NothingSelectsWhatIsNotDrawn) {
  GradientRecord gradient;
  gradient.id = "red";
  const RecordSelector selector("#red");
  EXPECT_THAT(selected_by({{}, {gradient, path("red~2")}}, {&selector, 1}),
              ElementsAre(kNotSelected, 0));
}

TEST(KeepSelected, KeepsAGroupsMembersAndWhatIsAroundIt) {
  EXPECT_THAT(kept(house(), "#inner"), ElementsAre("walls", "inner", "brick"));
}

TEST(KeepSelected, KeepsWhatTheSelectedRefersTo) {
  GradientRecord used, unused;
  used.id = "used";
  unused.id = "unused";
  ClipRecord outer, clip;
  outer.id = "outer";
  clip.id = "clip";
  clip.clip = "outer";
  PathRecord shown = path("shown");
  shown.style.stroke = PaintReference{"used"};
  shown.clip = "clip";
  EXPECT_THAT(kept({{}, {used, unused, outer, clip, shown, path("other")}}, "#shown"),
              ElementsAre("used", "outer", "clip", "shown"));
}

TEST(KeepSelected, KeepsWhatIsSaidOfTheSelected) {
  ConstraintRecord of_kept, of_other;
  of_kept.id = "of_kept";
  of_kept.curve = "a";
  of_other.id = "of_other";
  of_other.curve = "b";
  LabelRecord label;
  label.id = "label";
  label.of = "a";
  EXPECT_THAT(
      kept({{}, {of_kept, of_other, path("a"), path("b"), label, UnknownRecord{"{}", 0}}}, "#a"),
      ElementsAre("of_kept", "a", "label", "unknown"));
}

TEST(KeepSelected, SaysWhetherAnythingWas) {
  Document document = house();
  EXPECT_TRUE(keep_selected(document, RecordSelector("path")));
  EXPECT_FALSE(keep_selected(document, RecordSelector("circle")));
  EXPECT_THAT(document.records, IsEmpty());
}

// Selecting is a projection: twice is as once, and no reference leads nowhere that led somewhere.
TEST(KeepSelected, TwiceIsAsOnce) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Document once = any_document(seed);
    keep_selected(once, RecordSelector("path, rect, circle"));
    Document twice = once;
    keep_selected(twice, RecordSelector("path, rect, circle"));
    EXPECT_EQ(once, twice) << seed;
  }
}

}  // namespace
}  // namespace libstyle
