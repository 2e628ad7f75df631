// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/flatten.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "libstyle/base/error.h"
#include "libstyle/geometry/path_data.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;

TEST(Subpaths, KnowTheirVertices) {
  const auto parts = subpaths(parse_path_data("M0 0 L1 0 C2 0 2 1 2 2 Z M5 5 M7 7 L8 8"));
  ASSERT_EQ(parts.size(), 3u);
  ASSERT_EQ(parts[0].segments.size(), 3u);
  EXPECT_TRUE(parts[0].closed);
  EXPECT_TRUE(parts[0].segments[0].straight);
  EXPECT_FALSE(parts[0].segments[1].straight);
  EXPECT_EQ(parts[0].segments[1].start_vertex, 1u);
  EXPECT_EQ(parts[0].segments[1].end_vertex, 2u);
  EXPECT_EQ(parts[0].segments[2].start_vertex, 2u);  // the closing line
  EXPECT_EQ(parts[0].segments[2].end_vertex, 0u);
  EXPECT_EQ(parts[0].segments[2].curve.p3, (Point{0, 0}));
  EXPECT_TRUE(parts[1].segments.empty());
  EXPECT_EQ(parts[1].first_vertex, 3u);
  EXPECT_EQ(parts[2].segments[0].start_vertex, 4u);
  EXPECT_EQ(parts[2].segments[0].end_vertex, 5u);
}

TEST(Subpaths, ToPathAndBackIsTheSamePolyline) {
  for (const char* text : {"0 0, 4 0, 4 4 z", "0 0, 4 0, 4 4", "3 3"}) {
    const Path path = to_path(polyline(text));
    EXPECT_EQ(flatten(path, 1).at(0).polyline, polyline(text));
  }
  EXPECT_TRUE(to_path(Polyline{}).empty());
}

TEST(BoundingBox, OfAPathLeavesControlsOut) {
  const Box box = bounding_box(parse_path_data("M0 0 C0 4 4 4 4 0 L4 -1 Z M9 9"));
  EXPECT_THAT(box.low, PointNear({0, -1}, 1e-12));
  EXPECT_THAT(box.high, PointNear({9, 9}, 1e-12));
  EXPECT_THAT(bounding_box(parse_path_data("M0 0 C0 4 4 4 4 0")).high, PointNear({4, 3}, 1e-12));
  EXPECT_TRUE(bounding_box(Path{}).empty());
}

TEST(Flatten, StaysWithinTheToleranceAtEveryParameter) {
  for_each_seed(200, [](std::uint64_t seed) {
    RandomValues random(seed);
    const std::vector<Point> p = random_scribble(random, 4, 100).points;
    Path path;
    path.move_to(p[0]);
    path.cubic_to(p[1], p[2], p[3]);
    const double tolerance = std::pow(10, random.uniform(-3, 1));
    const FlattenedSubpath flat = flatten(path, tolerance).at(0);
    const CubicBezier curve{p[0], p[1], p[2], p[3]};
    double worst = 0;
    for (std::size_t i = 0; i + 1 < flat.places.size(); ++i) {
      for (double share = 0; share <= 1; share += 0.125) {
        const double t = flat.places[i].t + share * (flat.places[i + 1].t - flat.places[i].t);
        const Point on_line = lerp(flat.polyline.points[i], flat.polyline.points[i + 1], share);
        worst = std::max(worst, distance(on_line, point_at(curve, t)));
      }
    }
    ASSERT_LE(worst, tolerance);
    ASSERT_GT(worst, flat.places.size() > 4 ? 0.1 * tolerance : 0);  // nor far too careful
  });
}

TEST(Flatten, BoundIsSharpForAnEvenBend) {
  // A parabola: the second derivative is the same everywhere.
  const CubicBezier parabola{{0, 0}, {10, 20}, {20, 20}, {30, 0}};
  const double steps = flattening_steps(parabola, 0.1);
  const double chord_error = 6 * 20 / 8.0 / (steps * steps);
  EXPECT_LE(chord_error, 0.1);
  EXPECT_GT(6 * 20 / 8.0 / ((steps - 1) * (steps - 1)), 0.1);
}

TEST(Flatten, KeepsVerticesAndTellsWherePointsCameFrom) {
  const Path path = parse_path_data("M1 1 L9 1 C12 1 12 4 9 4 Z");
  const FlattenedSubpath flat = flatten(path, 0.05).at(0);
  ASSERT_EQ(flat.places.size(), flat.polyline.points.size());
  EXPECT_TRUE(flat.polyline.closed);
  EXPECT_EQ(flat.places[0], (PathPlace{0, 1, 0}));
  EXPECT_EQ(flat.places[1], (PathPlace{0, 1, 1}));
  EXPECT_EQ(flat.places.back(), (PathPlace{1, 2, 1}));
  EXPECT_EQ(flat.polyline.points.back(), (Point{9, 4}));
  const std::vector<double> values = values_along(flat.places, std::vector<double>{5, 7, 3});
  EXPECT_EQ(values.front(), 5);
  EXPECT_EQ(values[1], 7);
  EXPECT_EQ(values.back(), 3);
  EXPECT_NEAR(values[2], 7 - 4 * flat.places[2].t, 1e-12);
}

TEST(Flatten, DoesNotRepeatTheFirstPointOfClosedSubpaths) {
  EXPECT_EQ(flatten(parse_path_data("M0 0 L4 0 L4 4 L0 0 Z"), 1).at(0).polyline,
            polyline("0 0, 4 0, 4 4 z"));
  EXPECT_EQ(flatten(parse_path_data("M0 0 Z"), 1).at(0).polyline, polyline("0 0 z"));
  EXPECT_EQ(flatten(parse_path_data("M0 0 L0 0 Z"), 1).at(0).polyline, polyline("0 0 z"));
}

TEST(Flatten, RefusesWhatWouldNotEnd) {
  const double huge = std::numeric_limits<double>::max();
  Path path;
  path.move_to({0, 0});
  path.cubic_to({huge, 0}, {-huge, huge}, {1, 1});
  EXPECT_THROW(flatten(path, 0.1), Error);
  EXPECT_THROW(flatten(parse_path_data("M0 0 C1e15 0 0 1e15 1 1"), 0.1), Error);
}

}  // namespace
}  // namespace libstyle
