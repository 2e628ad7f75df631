// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/svg/arc.h"
#include "libstyle/geometry/path_data.h"

namespace libstyle::svg {
namespace {

using ::testing::ElementsAre;

TEST(RectangleShape, GoesRoundClockwiseFromItsCorner) {
  EXPECT_EQ(rectangle_path({1, 2, 10, 20}, {}, {}), parse_path_data("M1 2 L11 2 L11 22 L1 22 Z"));
}

TEST(RectangleShape, IsNothingWithoutASize) {
  EXPECT_TRUE(rectangle_path({1, 2, 0, 20}, {}, {}).empty());
  EXPECT_TRUE(rectangle_path({1, 2, 10, -1}, {}, {}).empty());
}

TEST(RectangleShape, TakesTheMissingRadiusFromTheOther) {
  const Path round = rectangle_path({0, 0, 100, 100}, 10, 10);
  EXPECT_EQ(rectangle_path({0, 0, 100, 100}, 10, {}), round);
  EXPECT_EQ(rectangle_path({0, 0, 100, 100}, {}, 10), round);
  EXPECT_EQ(rectangle_path({0, 0, 100, 100}, 10, -1), round);
  EXPECT_EQ(round.points().front(), (Point{10, 0}));
  EXPECT_EQ(round.points()[1], (Point{90, 0}));
}

TEST(RectangleShape, IsSharpWhenOneRadiusIsZero) {
  const Path sharp = rectangle_path({0, 0, 10, 10}, {}, {});
  EXPECT_EQ(rectangle_path({0, 0, 10, 10}, 0, 5), sharp);
  EXPECT_EQ(rectangle_path({0, 0, 10, 10}, 5, 0), sharp);
}

TEST(RectangleShape, LimitsRadiiToHalfTheSides) {
  // Nothing is left of the straight sides: an ellipse, begun at its top.
  const Path path = rectangle_path({0, 0, 20, 10}, 1000, 1000);
  EXPECT_EQ(path.points().front(), (Point{10, 0}));
  for (const Point& vertex : path.vertices()) {
    EXPECT_NEAR(norm({(vertex.x - 10) / 10, (vertex.y - 5) / 5}), 1, kArcError);
  }
  EXPECT_EQ(path.commands().size(), 14u);  // M, four quarters of three pieces, Z
}

TEST(EllipseShape, TouchesItsBoxInTheFourAxisPoints) {
  const Path path = ellipse_path({1, 2}, 10, 20);
  const std::vector<Point> vertices = path.vertices();
  EXPECT_THAT(std::vector<Point>({vertices[0], vertices[3], vertices[6], vertices[9]}),
              ElementsAre(Point{11, 2}, Point{1, 22}, Point{-9, 2}, Point{1, -18}));
  EXPECT_EQ(path.control_box(), (Box{{-9, -18}, {11, 22}}));
  EXPECT_EQ(path.commands().back(), PathCommand::kClose);
}

TEST(EllipseShape, IsNothingWithoutARadius) {
  EXPECT_TRUE(ellipse_path({1, 2}, 0, 20).empty());
  EXPECT_TRUE(ellipse_path({1, 2}, 10, -1).empty());
}

TEST(LineShape, IsALine) { EXPECT_EQ(line_path({1, 2}, {3, 4}), parse_path_data("M1 2 L3 4")); }

TEST(PolygonShape, ClosesWhatAPolylineLeavesOpen) {
  const std::vector<Point> points = {{0, 0}, {1, 0}, {1, 1}};
  EXPECT_EQ(polyline_path(points), parse_path_data("M0 0 L1 0 L1 1"));
  EXPECT_EQ(polygon_path(points), parse_path_data("M0 0 L1 0 L1 1 Z"));
  EXPECT_TRUE(polygon_path({}).empty());
  EXPECT_TRUE(polyline_path({}).empty());
}

TEST(Points, AreReadUpToTheFirstError) {
  EXPECT_THAT(parse_points("1,2 3-4").points, ElementsAre(Point{1, 2}, Point{3, -4}));
  EXPECT_TRUE(parse_points("1,2 3-4").complete);
  EXPECT_THAT(parse_points("1,2 3").points, ElementsAre(Point{1, 2}));
  EXPECT_FALSE(parse_points("1,2 3").complete);
  EXPECT_THAT(parse_points("1,2 3,4 5,x 6,7").points, ElementsAre(Point{1, 2}, Point{3, 4}));
  EXPECT_FALSE(parse_points("1,2 3,4 5,x 6,7").complete);
}

TEST(PointList, PassesOverWhatFollowsAPointAsLibrsvgDoes) {
  EXPECT_THAT(parse_points("1,2,,3,4").points, ElementsAre(Point{1, 2}, Point{3, 4}));
  EXPECT_TRUE(parse_points("1,2,,3,4").complete);
  EXPECT_FALSE(parse_points("1-2-3 4").complete);
  EXPECT_FALSE(parse_points("1,2 , 3,4").complete);
  EXPECT_FALSE(parse_points("1. 2.").complete);
}

}  // namespace
}  // namespace libstyle::svg
