// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/line_constraints.h"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "libstyle/base/error.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// The lines of a curve with sharp corners, and what is asked of each as "length: x y".
std::vector<std::vector<std::string>> asked(const Polyline& curve,
                                            const std::vector<CurveConstraint>& constraints,
                                            const std::vector<double>& held = {},
                                            bool keep_ends = true) {
  const std::vector<PlainLine> lines = split_into_lines(curve, 0.7, 5);
  const LineConstraints all(curve, lines, {held, constraints, keep_ends, 10});
  std::vector<std::vector<std::string>> result;
  for (const PlainLine& line : lines) {
    result.emplace_back();
    for (const LineConstraint& c : all.on(line)) {
      std::ostringstream text;
      text << c.length;
      if (c.position) text << " to " << c.position->x << ' ' << c.position->y;
      if (c.weight) text << " by " << *c.weight;
      result.back().push_back(text.str());
    }
  }
  return result;
}

TEST(LineConstraints, AreOnTheLineThatHasTheirPlace) {
  EXPECT_THAT(asked(polyline("0 0, 100 0, 100 100"), {{0.75, {9, 9}, {}}}),
              ElementsAre(ElementsAre("0", "100"), ElementsAre("0", "50 to 9 9", "100")));
}

TEST(LineConstraints, AtACornerAreOnBothLines) {
  EXPECT_THAT(asked(polyline("0 0, 100 0, 100 100"), {{0.5, {9, 9}, {}}}),
              ElementsAre(ElementsAre("0", "100 to 9 9"), ElementsAre("0 to 9 9", "100")));
}

TEST(LineConstraints, AtTheFirstCornerOfAnOutlineAreOnTheLastLineToo) {
  const auto lines = asked(polyline("0 0, 100 0, 100 100, 0 100 z"), {{1, {-9, -9}, {}}});
  EXPECT_THAT(lines.front(), ElementsAre("0 to -9 -9", "100"));
  EXPECT_THAT(lines.back(), ElementsAre("0", "100 to -9 -9"));
}

TEST(LineConstraints, WhereALineGoesOnPastTheSeamComeWithIt) {
  const auto lines = asked(polyline("50 0, 100 0, 100 100, 0 100, 0 0 z"), {{0.025, {9, 9}, {}}});
  EXPECT_THAT(lines.back(), ElementsAre("0", "60 to 9 9", "100"));
}

TEST(LineConstraints, ComeBeforeEndsAndHeldPlaces) {
  EXPECT_THAT(asked(polyline("0 0, 100 0"), {{0, {1, 1}, {}}, {0.5, {2, 2}, {}}}, {30, 50}),
              ElementsAre(ElementsAre("0 to 1 1", "30", "50 to 2 2", "100")));
}

// Half-way at a weight of the inverse square of the deviation, here 10 px.
TEST(LineConstraints, SoftOnesAtEndsAndHeldPlacesMakeThemGiveWay) {
  EXPECT_THAT(asked(polyline("0 0, 100 0"), {{0, {0, 8}, 0.01}, {0.3, {30, 4}, 0.01}}, {30}),
              ElementsAre(ElementsAre("0 to 0 4", "30 to 30 2", "100")));
}

TEST(LineConstraints, WithLooseEndsNothingElseIsHeld) {
  EXPECT_THAT(asked(polyline("0 0, 100 0"), {{0, {0, 8}, 0.01}}, {30}, false),
              ElementsAre(ElementsAre("0 to 0 8 by 0.01")));
  EXPECT_THAT(asked(polyline("0 0, 100 0"), {}, {30}, false), ElementsAre(IsEmpty()));
}

TEST(LineConstraints, OnOnePlaceAreOne) {
  EXPECT_THAT(asked(polyline("0 0, 100 0"), {{0.5, {0, 8}, 1}, {0.5, {0, 4}, 3}}),
              ElementsAre(ElementsAre("0", "50 to 0 5 by 4", "100")));
  EXPECT_THAT(asked(polyline("0 0, 100 0"), {{0.5, {0, 8}, 1}, {0.5, {0, 4}, {}}}),
              ElementsAre(ElementsAre("0", "50 to 0 4", "100")));
  EXPECT_THAT(asked(circle({0, 0}, 10, 40), {{0, {9, 9}, {}}, {1, {9, 9}, {}}}),
              ElementsAre(ElementsAre("0 to 9 9")));
}

TEST(LineConstraints, RefuseWhatCannotBe) {
  const Polyline line = polyline("0 0, 100 0"), ring = circle({0, 0}, 10, 40);
  EXPECT_THROW(asked(line, {{0.5, {0, 8}, {}}, {0.5 + 1e-9, {0, 4}, {}}}), Error);
  EXPECT_THROW(asked(ring, {{0, {0, 8}, {}}, {1, {0, 4}, {}}}), Error);
  for (const double t : {-0.1, 1.1, std::nan("")}) {
    EXPECT_THROW(asked(line, {{t, {0, 8}, {}}}), Error);
  }
  for (const double weight : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    EXPECT_THROW(asked(line, {{0.5, {0, 8}, weight}}), Error);
  }
  EXPECT_THROW(asked(line, {{0.5, {0, std::nan("")}, {}}}), Error);
}

}  // namespace
}  // namespace libstyle
