// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/example_document.h"

#include <gmock/gmock.h>

#include "libstyle/base/error.h"
#include "libstyle/geometry/path_data.h"

namespace libstyle {
namespace {

Document document_of(std::initializer_list<std::string_view> paths) {
  Document document;
  for (const std::string_view data : paths) {
    PathRecord record;
    record.path = parse_path_data(data);
    document.records.push_back(record);
  }
  return document;
}

TEST(ExamplePairs, PairCurvesInTheirOrder) {
  const Document plain = document_of({"M0 0 L10 0", "M0 20 L10 20 M0 40 L10 40"});
  const Document styled = document_of({"M0 0 L5 1 L10 0 M0 20 L5 21 L10 20", "M0 40 L5 41 L10 40"});
  const std::vector<ExamplePair> pairs = example_pairs(&plain, styled);
  ASSERT_EQ(pairs.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(pairs[i].unfiltered->polyline.points.front(),
              (Point{0, 20.0 * static_cast<double>(i)}));
    EXPECT_EQ(pairs[i].filtered.polyline.points[1], (Point{5, 20.0 * static_cast<double>(i) + 1}));
    EXPECT_FALSE(pairs[i].same_parameter);
  }
}

TEST(ExamplePairs, WithoutUnfilteredCurvesHaveNone) {
  const std::vector<ExamplePair> pairs = example_pairs(nullptr, document_of({"M0 0 L9 9", "M5 5"}));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_FALSE(pairs[0].unfiltered);
}

TEST(ExamplePairs, ManyVerticesOfTheSameNumberBelongTogether) {
  const Document plain = document_of({"M0 0 L1 0 L2 0 L3 0 L4 0 L5 0 L6 0 L70 0"});
  const Document styled = document_of({"M0 0 L1 1 L2 0 L3 1 L4 0 C5 0 5 1 5 1 L6 0 L70 1"});
  const std::vector<ExamplePair> pairs = example_pairs(&plain, styled);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_TRUE(pairs[0].same_parameter);
  EXPECT_EQ(pairs[0].unfiltered->t.back(), 7);
  EXPECT_EQ(pairs[0].filtered.t.back(), 7);
  EXPECT_EQ(point_at_parameter(*pairs[0].unfiltered, 6.5), (Point{38, 0}));
}

TEST(ExamplePairs, BringWhatAllCurvesHaveAlong) {
  Document styled = document_of({"M0 0 L5 5 L10 0", "M0 20 L10 20"});
  std::get<PathRecord>(styled.records[0]).along.channels = {
      {"tilt", {1, 2, 3}}, {"t", {0, 0.5, 1}}, {"width", {1, 4, 2}}};
  std::get<PathRecord>(styled.records[1]).along.channels = {{"width", {3, 5}}};
  const std::vector<ExamplePair> pairs = example_pairs(nullptr, styled);
  for (const ExamplePair& pair : pairs) {
    EXPECT_THAT(pair.features, testing::ElementsAre(LineFeature{"width", FeatureKind::kLength}));
  }
  EXPECT_THAT(pairs[0].filtered.channels, testing::ElementsAre(testing::ElementsAre(1, 4, 2)));
  EXPECT_THAT(pairs[1].filtered.channels, testing::ElementsAre(testing::ElementsAre(3, 5)));
}

TEST(ExamplePairs, MoreFilteredCurvesAreStrokes) {
  const Document plain = document_of({"M0 0 L10 0", "M0 20 L10 20"});
  const Document styled =
      document_of({"M0 19 L5 20", "M0 1 L10 -1", "M4 21 L10 20", "M0 22 L9 21"});
  const std::vector<ExamplePair> pairs = example_pairs(&plain, styled);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].filtered.polyline.points.front(), (Point{0, 1}));
  EXPECT_TRUE(pairs[0].others.empty());
  EXPECT_EQ(pairs[1].filtered.polyline.points.front(), (Point{0, 19}));
  ASSERT_EQ(pairs[1].others.size(), 2u);
  EXPECT_EQ(pairs[1].others[0].polyline.points.front(), (Point{4, 21}));
}

TEST(ExamplePairs, GivenParametersComeFirst) {
  Document plain = document_of({"M0 0 L10 0"}), styled = document_of({"M0 0 L2 3 L10 0"});
  std::get<PathRecord>(plain.records[0]).along.channels = {{"t", {0, 1}}};
  std::get<PathRecord>(styled.records[0]).along.channels = {{"t", {0, 0.25, 1}}};
  const std::vector<ExamplePair> pairs = example_pairs(&plain, styled);
  EXPECT_TRUE(pairs[0].same_parameter);
  EXPECT_THAT(pairs[0].filtered.t, testing::ElementsAre(0, 0.25, 1));
}

TEST(ExamplePairs, SayWhatIsMissing) {
  const auto complaint = [](const Document* plain, const Document& styled) {
    try {
      example_pairs(plain, styled);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const Document none, one = document_of({"M0 0 L1 0"}),
                       two = document_of({"M0 0 L1 0", "M0 9 L1 9"});
  EXPECT_THAT(complaint(nullptr, none), testing::HasSubstr("no curve"));
  EXPECT_THAT(complaint(&two, one), testing::HasSubstr("2 curves, the filtered one 1 curve"));
  const Document three = document_of({"M0 0 L1 0", "M0 1 L1 1", "M0 2 L1 2"});
  EXPECT_THAT(complaint(&two, three), testing::HasSubstr("along the unfiltered curve 2"));
}

}  // namespace
}  // namespace libstyle
