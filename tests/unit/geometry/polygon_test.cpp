// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

TEST(Polygon, MeasuresASquare) {
  const auto square = polyline("1 1, 3 1, 3 3, 1 3").points;  // clockwise on the page
  EXPECT_EQ(signed_area(square), 4);
  EXPECT_EQ(centroid(square), (Point{2, 2}));
  EXPECT_EQ(winding_number(square, {2, 2}), 1);
  EXPECT_EQ(winding_number(square, {4, 2}), 0);
  const auto backwards = polyline("1 3, 3 3, 3 1, 1 1").points;
  EXPECT_EQ(signed_area(backwards), -4);
  EXPECT_EQ(winding_number(backwards, {2, 2}), -1);
  EXPECT_TRUE(contains(backwards, {2, 2}));
}

TEST(Polygon, BoundaryPointsCountOnce) {
  // Four squares tile a larger one: a shift to the right and below decides for each point of it,
  // and no point is in two or in none.
  const auto tiles = {polyline("0 0, 2 0, 2 2, 0 2"), polyline("2 0, 4 0, 4 2, 2 2"),
                      polyline("0 2, 2 2, 2 4, 0 4"), polyline("2 2, 4 2, 4 4, 2 4")};
  for (double x = 0; x < 4; x += 0.5) {
    for (double y = 0; y < 4; y += 0.5) {
      int count = 0;
      for (const Polyline& tile : tiles) count += contains(tile.points, {x, y});
      EXPECT_EQ(count, 1) << x << " " << y;
    }
  }
}

TEST(Polygon, WindingNumberCountsTurnsOfTheAngle) {
  for_each_seed(100, [](std::uint64_t seed) {
    RandomValues random(seed);
    const std::vector<Point> wild = random_scribble(random, 12, 10).points;
    const double x = random.uniform(0, 10);
    const Point point{x, random.uniform(0, 10)};
    double turned = 0;
    for (std::size_t i = 0; i < wild.size(); ++i) {
      turned += turning_angle(wild[i] - point, wild[(i + 1) % wild.size()] - point);
    }
    ASSERT_EQ(winding_number(wild, point),
              static_cast<int>(std::lround(turned / (2 * std::numbers::pi))));
  });
}

TEST(Polygon, AreaAndCentroidMoveWithThePolygon) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    const Polyline blob = random_blob(random, 40);
    const Vector far{1e6, -3e6};
    std::vector<Point> moved;
    for (const Point p : blob.points) moved.push_back(p + far);
    ASSERT_NEAR(signed_area(moved), signed_area(blob.points), 1e-6);
    ASSERT_THAT(centroid(moved) - far, PointNear(centroid(blob.points), 1e-7));
  });
}

TEST(Polygon, WithoutAreaHasTheCentroidOfItsBoundary) {
  EXPECT_EQ(centroid(polyline("0 0, 4 0").points), (Point{2, 0}));
  EXPECT_EQ(centroid(polyline("7 7, 7 7").points), (Point{7, 7}));
  EXPECT_THAT(centroid(polyline("0 0.1, 1 0.4, 3 1.0").points), PointNear({1.5, 0.55}, 1e-12));
}

TEST(TurningAngle, IsSignedAndFullRange) {
  EXPECT_NEAR(turning_angle({1, 0}, {0, 2}), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(turning_angle({0, 2}, {1, 0}), -std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(turning_angle({1, 0}, {-1, 0}), std::numbers::pi, 1e-15);
  EXPECT_EQ(turning_angle({0, 0}, {1, 0}), 0);
}

}  // namespace
}  // namespace libstyle
