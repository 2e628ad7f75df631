// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/line_features.h"

#include <gmock/gmock.h>

namespace libstyle {
namespace {

AlongValues brush() {
  AlongValues along;
  along.channels = {{"pressure", {0, 1}}, {"t", {3, 4}}, {"width", {2, 5}}};
  along.colors = {{1, 2, 3, 4}, {10, 20, 30, 255}};
  return along;
}

std::vector<std::vector<double>> values_of(const AlongValues& along) {
  std::vector<std::vector<double>> rows;
  for (const LineFeature& feature : line_features(along)) {
    rows.push_back(feature_values(along, feature));
  }
  return rows;
}

TEST(LineFeatures, AreAllButTheParameter) {
  using Kind = FeatureKind;
  EXPECT_THAT(line_features(brush()),
              testing::ElementsAre(
                  LineFeature{"pressure", Kind::kNumber}, LineFeature{"width", Kind::kLength},
                  LineFeature{"color", Kind::kRed}, LineFeature{"color", Kind::kGreen},
                  LineFeature{"color", Kind::kBlue}, LineFeature{"color", Kind::kAlpha}));
}

TEST(LineFeatures, ComeBackAsTheyWere) {
  AlongValues fresh;
  set_features(fresh, line_features(brush()), values_of(brush()));
  AlongValues expected = brush();
  expected.channels.erase(expected.channels.begin() + 1);  // t
  EXPECT_EQ(fresh, expected);
}

TEST(LineFeatures, TakeThePlaceOfThoseOfTheSameName) {
  AlongValues along;
  along.channels = {{"width", {7, 7}}, {"tilt", {5, 6}}};
  set_features(along, line_features(brush()), values_of(brush()));
  ASSERT_EQ(along.channels.size(), 3u);
  EXPECT_EQ(along.channels[0], (Channel{"width", {2, 5}}));
  EXPECT_EQ(along.channels[1], (Channel{"tilt", {5, 6}}));
  EXPECT_EQ(along.channels[2], (Channel{"pressure", {0, 1}}));
}

}  // namespace
}  // namespace libstyle
