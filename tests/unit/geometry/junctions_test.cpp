// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/junctions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libstyle/base/error.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<Polyline> drawing(std::initializer_list<const char*> texts) {
  std::vector<Polyline> curves;
  for (const char* text : texts) curves.push_back(polyline(text));
  return curves;
}

// "0< 1- 2>": curve 0 starts here, passes through with 1, ends with 2.
std::string summary(const Junction& junction) {
  std::string text;
  for (const JunctionMember& member : junction.members) {
    constexpr char kSigns[] = {'<', '>', '-'};
    if (!text.empty()) text += ' ';
    text += std::to_string(member.at.curve) + kSigns[static_cast<int>(member.role)];
  }
  return text;
}

TEST(FindJunctions, JoinsEndsWithinTheTolerance) {
  const auto curves = drawing({"0 0, 10 0", "10.3 0.2, 20 0", "10 -0.4, 10 -9", "40 0, 50 0"});
  const JunctionGraph graph = find_junctions(curves, 1.0);
  ASSERT_THAT(graph.junctions, SizeIs(1));
  EXPECT_EQ(summary(graph.junctions[0]), "0> 1< 2<");
  EXPECT_THAT(graph.junctions[0].position, PointNear({10.1, -0.2 / 3}, 1e-12));
  EXPECT_THAT(graph.junctions_of_curve,
              ElementsAre(ElementsAre(0), ElementsAre(0), ElementsAre(0), IsEmpty()));
  EXPECT_THAT(find_junctions(curves, 0.1).junctions, IsEmpty());
}

TEST(FindJunctions, AttachesEndsToInteriors) {
  // One tributary stops short of the main stream, one overshoots, two meet at the same place.
  const auto curves = drawing(
      {"0 0, 100 0", "20 30, 20 0.4", "50 30, 50 -0.4", "80 30, 80 0.3", "80 -30, 80.2 -0.3"});
  const JunctionGraph graph = find_junctions(curves, 1.0);
  ASSERT_THAT(graph.junctions, SizeIs(3));
  EXPECT_EQ(summary(graph.junctions[0]), "0- 1>");
  EXPECT_THAT(graph.junctions[0].position, PointNear({20, 0}, 1e-12));
  EXPECT_EQ(summary(graph.junctions[1]), "0- 2>");
  EXPECT_EQ(summary(graph.junctions[2]), "0- 3> 4>");
  EXPECT_NEAR(graph.junctions[2].members[0].at.place.fraction, 0.8, 0.01);
  EXPECT_THAT(graph.junctions_of_curve[0], ElementsAre(0, 1, 2));
}

TEST(FindJunctions, FindsCurvesThatMeetThemselves) {
  // A six: its end lies on its own side. An all but closed ring: its ends meet.
  Polyline six = arc({0, 0}, 10, -std::numbers::pi / 2, 1.5 * std::numbers::pi - 0.02, 200);
  six.points.insert(six.points.begin(), {-20, -12});
  Polyline ring = arc({50, 0}, 10, 0, 2 * std::numbers::pi - 0.02, 200);
  const std::vector<Polyline> curves = {six, ring};
  const JunctionGraph graph = find_junctions(curves, 0.5);
  ASSERT_THAT(graph.junctions, SizeIs(2));
  EXPECT_EQ(summary(graph.junctions[0]), "0- 0>");
  EXPECT_EQ(summary(graph.junctions[1]), "1< 1>");
  EXPECT_THAT(graph.junctions_of_curve[1], ElementsAre(1, 1));
}

TEST(FindJunctions, DoesNotTakeAnEndForItsOwnInterior) {
  const auto curves = drawing({"0 0, 0.1 0, 0.2 0, 30 0", "0 0.1, -30 9"});
  const JunctionGraph graph = find_junctions(curves, 0.5);
  ASSERT_THAT(graph.junctions, SizeIs(1));
  EXPECT_EQ(summary(graph.junctions[0]), "0< 1<");
}

TEST(FindJunctions, LeavesCrossingsAlone) {
  EXPECT_THAT(find_junctions(drawing({"0 0, 10 10", "0 10, 10 0"})).junctions, IsEmpty());
}

TEST(FindJunctions, MeetsClosedCurvesOnTheirInterior) {
  const auto curves = drawing({"0 0, 10 0, 10 10, 0 10 z", "30 5, 10.2 5"});
  const JunctionGraph graph = find_junctions(curves, 0.5);
  ASSERT_THAT(graph.junctions, SizeIs(1));
  EXPECT_EQ(summary(graph.junctions[0]), "0- 1>");
  EXPECT_EQ(graph.junctions[0].members[0].at.place, (PolylinePlace{1, 0.5}));
}

// A river as such drawings are: tributaries end up to 0.6 % of the diagonal off a host that is a
// wiggly polyline itself.
TEST(FindJunctions, MakesATreeOfAnUnsnappedRiver) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    std::vector<Polyline> curves;
    Polyline main;
    for (int i = 0; i <= 200; ++i) {
      main.points.push_back({3.0 * i, 20 * std::sin(0.1 * i) + random.uniform(-1, 1)});
    }
    curves.push_back(main);
    const double diagonal = 720;
    for (std::size_t i = 0; i < 12; ++i) {
      const Point mouth = main.points[10 + 16 * i];
      const double side = i % 2 == 0 ? 1 : -1;
      Polyline tributary;
      for (int k = 20; k > 0; --k) {
        tributary.points.push_back(mouth + Vector{random.uniform(-2, 2), side * (3 + 7.0 * k)});
      }
      const double miss = random.uniform(0, 0.006 * diagonal), angle = random.uniform(0, 6.3);
      tributary.points.push_back(mouth + miss * Vector{std::cos(angle), std::sin(angle)});
      curves.push_back(tributary);
    }
    const JunctionGraph graph = find_junctions(curves);
    ASSERT_NEAR(graph.tolerance, 0.01 * diagonal, 0.2 * graph.tolerance);
    ASSERT_THAT(graph.junctions, SizeIs(12));
    ASSERT_THAT(graph.junctions_of_curve[0], SizeIs(12));
    for (std::size_t i = 0; i < 12; ++i) {
      ASSERT_EQ(summary(graph.junctions[i]), "0- " + std::to_string(i + 1) + ">");
      ASSERT_THAT(graph.junctions[i].position, PointNear(main.points[10 + 16 * i], 7.2));
    }
  });
}

TEST(FindJunctions, KeepsShortStrokesApartByItself) {
  // A hundred strokes of length 1, ten apart: 1 % of the diagonal would be longer than they are.
  std::vector<Polyline> curves;
  for (int i = 0; i < 100; ++i) curves.push_back({{{10.0 * i, 0}, {10.0 * i, 1}}, false});
  const JunctionGraph graph = find_junctions(curves);
  EXPECT_LE(graph.tolerance, 0.25);
  EXPECT_THAT(graph.junctions, IsEmpty());
}

TEST(FindJunctions, TakesEmptyAndDegenerateCurves) {
  EXPECT_THAT(find_junctions({}).junctions, IsEmpty());
  const auto curves = drawing({"1 1", "1 1, 1 1", "1 1, 2 2", ""});
  const JunctionGraph graph = find_junctions(curves, 0.1);
  EXPECT_THAT(graph.junctions, IsEmpty());
  EXPECT_THAT(graph.junctions_of_curve, SizeIs(4));
  EXPECT_THROW(find_junctions(curves, -1), Error);
}

}  // namespace
}  // namespace libstyle
