// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/record_ids.h"

#include <gtest/gtest.h>

namespace libstyle::svg {
namespace {

template <typename T>
T with_id(const std::string& id) {
  T record;
  record.id = id;
  return record;
}

Document document_of(Records records) { return {{}, std::move(records)}; }

TEST(RecordIds, KeepsGivenIds) {
  const Document document = document_of({with_id<PathRecord>("a (1)"), with_id<GroupRecord>("b")});
  const RecordIds ids(document);
  EXPECT_EQ(ids.at(0), "a (1)");
  EXPECT_EQ(ids.at(1), "b");
  EXPECT_EQ(ids.find("b"), "b");
  EXPECT_EQ(ids.find("c"), "");
}

TEST(RecordIds, CutsMadeIdsWhereNobodyElseHasThem) {
  const Document document = document_of({with_id<PathRecord>("a~1"), with_id<PathRecord>("a~2"),
                                         with_id<PathRecord>("b~1"), with_id<PathRecord>("b"),
                                         with_id<PathRecord>("~7")});
  const RecordIds ids(document);
  EXPECT_EQ(ids.at(0), "a");
  EXPECT_EQ(ids.at(1), "");
  EXPECT_EQ(ids.at(2), "");
  EXPECT_EQ(ids.at(3), "b");
  EXPECT_EQ(ids.at(4), "");
}

TEST(RecordIds, MakesAnIdForWhatIsReferredTo) {
  ConstraintRecord constraint;
  constraint.curve = "a~2";
  const Document document =
      document_of({with_id<GradientRecord>("g"), with_id<GradientRecord>("g~2"),
                   with_id<ClipRecord>("~1"), with_id<PathRecord>("g-1"), with_id<PathRecord>("a"),
                   with_id<PathRecord>("a~2"), constraint});
  const RecordIds ids(document);
  EXPECT_EQ(ids.find("g"), "g");
  EXPECT_EQ(ids.find("g~2"), "g-2");  // g-1 is taken by the path
  EXPECT_EQ(ids.find("~1"), "clip-1");
  EXPECT_EQ(ids.find("a~2"), "a-2");
}

TEST(RecordIds, KeepsNamedContainersApart) {
  const Document document = document_of(
      {with_id<GroupRecord>("g"), with_id<GroupRecord>("g~2"), with_id<GroupRecord>("~1")});
  const RecordIds ids(document);
  EXPECT_EQ(ids.at(1), "g-2");
  EXPECT_EQ(ids.at(2), "");
}

TEST(RecordIds, ReplacesWhatWouldEndAUrl) {
  const Document document =
      document_of({with_id<GradientRecord>("a b(1)'"), with_id<ClipRecord>("a b(1)\"")});
  const RecordIds ids(document);
  EXPECT_EQ(ids.at(0), "a_b_1__");
  EXPECT_EQ(ids.at(1), "a_b_1__-1");
}

TEST(RecordIds, GivesNoIdTwice) {
  const Document document = document_of({with_id<PathRecord>("a"), with_id<GroupRecord>("a"),
                                         with_id<GradientRecord>("a"), with_id<ClipRecord>("a~1")});
  const RecordIds ids(document);
  EXPECT_EQ(ids.at(0), "a");
  EXPECT_EQ(ids.at(1), "a-1");
  EXPECT_EQ(ids.at(2), "a-2");
  EXPECT_EQ(ids.at(3), "a-3");
}

}  // namespace
}  // namespace libstyle::svg
