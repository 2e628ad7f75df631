// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/nesting.h"

#include <gtest/gtest.h>

#include <string>

namespace libstyle {
namespace {

GroupRecord group(const std::string& id, const std::string& parent = "") {
  GroupRecord record;
  record.id = id;
  record.parent = parent;
  return record;
}

PathRecord path(const std::string& parent) {
  PathRecord record;
  record.parent = parent;
  return record;
}

// The containers opened and closed, as brackets with their place, around the places of the paths.
std::string walk(const Document& document) {
  const Containers containers(document);
  std::string text;
  Nesting nesting(
      containers, [&](std::size_t place) { text += std::to_string(place) + "("; },
      [&](std::size_t) { text += ")"; });
  for (std::size_t i = 0; i < document.records.size(); ++i) {
    if (std::holds_alternative<PathRecord>(document.records[i])) {
      nesting.enter(containers.of(i));
      text += " " + std::to_string(i) + " ";
    } else {
      nesting.enter(i);
    }
  }
  nesting.enter(Containers::kNone);
  return text;
}

TEST(Nesting, OpensAndClosesAsMembersAsk) {
  EXPECT_EQ(walk({{}, {group("a"), path("a"), group("b", "a"), path("b"), path("a"), path("")}}),
            "0( 1 2( 3 ) 4 ) 5 ");
}

TEST(Nesting, KeepsEmptyGroups) {
  EXPECT_EQ(walk({{}, {group("a"), group("b", "a"), group("c")}}), "0(1())2()");
}

TEST(Nesting, OpensAgainWhatWasLeft) {
  EXPECT_EQ(walk({{}, {group("a"), group("b", "a"), path("b"), path(""), path("b")}}),
            "0(1( 2 )) 3 0(1( 4 ))");
}

TEST(Nesting, TakesElementsAsContainersToo) {
  ElementRecord element;
  element.id = "e";
  EXPECT_EQ(walk({{}, {element, path("e")}}), "0( 1 )");
}

TEST(Containers, AreNoneWhenTheyAreMissingOrComeLater) {
  const Document document = {{}, {path("later"), group("later"), path("nowhere"), path("later")}};
  const Containers containers(document);
  EXPECT_EQ(containers.of(0), Containers::kNone);
  EXPECT_EQ(containers.of(2), Containers::kNone);
  EXPECT_EQ(containers.of(3), 1u);
}

TEST(Containers, AreNeverTheGroupItself) {
  const Document document = {{}, {group("a", "a")}};
  EXPECT_EQ(Containers(document).of(0), Containers::kNone);
}

}  // namespace
}  // namespace libstyle
