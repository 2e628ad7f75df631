// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/cubic_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/flatten.h"
#include "libstyle/geometry/path_data.h"
#include "libstyle/geometry/sampled_curve.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;

// By brute force over a fine flattening.
double distance_to(const Polyline& polyline, Point point) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < segment_count(polyline); ++i) {
    const Point a = segment_start(polyline, i);
    const Vector along = segment_end(polyline, i) - a;
    const double t = squared_norm(along) > 0
                         ? std::clamp(dot(point - a, along) / squared_norm(along), 0.0, 1.0)
                         : 0;
    best = std::min(best, distance(point, a + t * along));
  }
  return best;
}

double largest_distance(const Polyline& points, const Path& path) {
  const Polyline flat = flatten(path, 1e-4).at(0).polyline;
  if (flat.points.size() == 1) return distance(points.points.back(), flat.points.front());
  double worst = 0;
  for (const Point p : points.points) worst = std::max(worst, distance_to(flat, p));
  return worst;
}

// Strokes, scribbles, outlines and lattice walks, open and closed, clean and shaky.
Polyline random_drawing(std::uint64_t seed) {
  RandomValues random(seed);
  Polyline curve;
  switch (seed % 4) {
    case 0:
      curve = random_stroke(random, 2 + random.below(200));
      break;
    case 1:
      curve = random_scribble(random, 2 + random.below(20), 50);
      break;
    case 2:
      curve = random_blob(random, 3 + random.below(200));
      break;
    default:
      curve = random_lattice_walk(random, 2 + random.below(30), 6);
  }
  if (random.chance(0.3)) curve.closed = true;
  if (random.chance(0.5)) curve = with_noise(std::move(curve), random, random.uniform(0, 0.3));
  return curve;
}

TEST(FitCubics, StaysWithinTheToleranceItPromises) {
  for_each_seed(400, [](std::uint64_t seed) {
    const Polyline curve = random_drawing(seed);
    const double tolerance = std::pow(10, RandomValues(seed + 1).uniform(-1.5, 0.5));
    const CubicFit fit = fit_cubics(curve, {.tolerance = tolerance});
    ASSERT_LE(fit.error, tolerance * (1 + 1e-9));
    ASSERT_LE(largest_distance(curve, fit.path), fit.error + 2e-4);
  });
}

TEST(FitCubics, KeepsEndsAndCornersAndNamesItsPoints) {
  for_each_seed(200, [](std::uint64_t seed) {
    const Polyline curve = random_drawing(seed);
    const CubicFit fit = fit_cubics(curve, {.tolerance = 0.5});
    const std::vector<Point> vertices = fit.path.vertices();
    ASSERT_EQ(fit.points.size(), vertices.size());
    ASSERT_EQ(fit.corners.size(), vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Point p = curve.points[fit.points[i]];
      ASSERT_TRUE(!fit.corners[i] || vertices[i] == p);
      ASSERT_THAT(vertices[i], PointNear(p, 0.25 + 1e-9));
    }
    if (!curve.closed) {
      ASSERT_EQ(vertices.front(), curve.points.front());
      ASSERT_EQ(vertices.back(), curve.points.back());
      ASSERT_TRUE(std::ranges::is_sorted(fit.points));
    }
    const bool ends_in_close = fit.path.commands().back() == PathCommand::kClose;
    ASSERT_EQ(ends_in_close, curve.closed);
  });
}

TEST(FitCubics, IsSmoothWhereThereAreNoCorners) {
  for_each_seed(100, [](std::uint64_t seed) {
    RandomValues random(seed);
    const bool closed = seed % 2 == 1;
    const Polyline curve = closed ? random_blob(random, 200) : random_stroke(random, 200);
    const CubicFit fit = fit_cubics(curve, {.tolerance = 0.2, .corner_angle = std::numbers::pi});
    const std::vector<PathSegment> segments = subpaths(fit.path).at(0).segments;
    ASSERT_GT(segments.size(), 1u);
    for (std::size_t i = 0; i + (closed ? 0 : 1) < segments.size(); ++i) {
      const CubicBezier& next = segments[(i + 1) % segments.size()].curve;
      const Vector before = tangent_at(segments[i].curve, 1), after = tangent_at(next, 0);
      ASSERT_THAT(after, PointNear(before, 1e-6)) << "after segment " << i;
    }
  });
}

// Turns along a segment add up to no more than half a turn: neither loops nor cusps.
TEST(FitCubics, DrawsNoLoopsInsideSegments) {
  for_each_seed(200, [](std::uint64_t seed) {
    const CubicFit fit = fit_cubics(random_drawing(seed), {.tolerance = 0.5});
    if (fit.path.empty()) return;
    const Subpath subpath = subpaths(fit.path).at(0);
    for (const PathSegment& segment : subpath.segments) {
      double turn = 0;
      for (int i = 0; i < 200; ++i) {
        const Vector a = derivative_at(segment.curve, (i + 0.5) / 201);
        const Vector b = derivative_at(segment.curve, (i + 1.5) / 201);
        turn += std::abs(std::atan2(cross(a, b), dot(a, b)));
      }
      ASSERT_LE(turn, std::numbers::pi + 1e-6);
    }
  });
}

TEST(FitCubics, PassesExactlyAndSmoothlyWhereItIsAskedTo) {
  for_each_seed(200, [](std::uint64_t seed) {
    RandomValues random(seed);
    const Polyline curve =
        seed % 2 ? random_blob(random, 60) : with_noise(random_stroke(random, 200), random, 0.1);
    const std::size_t through[] = {0, 1 + random.below(20), 25, 26 + random.below(30)};
    const CubicFit fit =
        fit_cubics(curve, {.tolerance = 1, .corner_angle = std::numbers::pi}, through);
    const std::vector<Point> vertices = fit.path.vertices();
    for (const std::size_t point : through) EXPECT_THAT(vertices, Contains(curve.points[point]));
    EXPECT_LE(fit.error, 1);
    EXPECT_THAT(fit.corners, Each(false));
  });
}

TEST(FitCubics, NeedsFewSegmentsForACircle) {
  const CubicFit fit = fit_cubics(circle({5, 5}, 100, 1000), {.tolerance = 0.1});
  EXPECT_LE(fit.path.vertex_count(), 5u);
  EXPECT_LT(fit.error, 0.1);
}

TEST(FitCubics, FindsTheCurveThatWasFlattened) {
  const Path path = parse_path_data("M0 0 C40 -60 80 60 120 0 C150 -45 180 0 200 40");
  const CubicFit fit = fit_cubics(flatten(path, 0.001).at(0).polyline, {.tolerance = 0.3});
  EXPECT_LE(fit.path.vertex_count(), 4u);
}

TEST(FitCubics, SmoothsNoiseInsteadOfFollowingIt) {
  for_each_seed(20, [](std::uint64_t seed) {
    RandomValues random(seed);
    Polyline wave;
    for (int i = 0; i <= 1000; ++i) wave.points.push_back({0.2 * i, 20 * std::sin(0.04 * i)});
    const CubicFit fit = fit_cubics(with_noise(wave, random, 0.1), {.tolerance = 0.6});
    ASSERT_LE(fit.path.vertex_count(), 26u);  // six and a half half-waves
    const Polyline flat = flatten(fit.path, 0.01).at(0).polyline;
    EXPECT_NEAR(arc_length(flat), arc_length(wave), 0.01 * arc_length(wave));
  });
}

TEST(FitCubics, OfStraightPiecesIsLines) {
  const CubicFit open = fit_cubics(resample(polyline("0 0, 30 0, 30 40"), 0.5));
  EXPECT_EQ(to_path_data(open.path), "M0 0 L30 0 L30 40");
  EXPECT_THAT(open.corners, ElementsAre(false, true, false));
  const CubicFit closed = fit_cubics(polyline("0 0, 30 0, 30 40, 0 40 z"));
  EXPECT_EQ(to_path_data(closed.path), "M0 0 L30 0 L30 40 L0 40 L0 0 Z");
  EXPECT_EQ(closed.error, 0);
}

TEST(FitCubics, KeepsLongEdgesStraight) {
  Polyline stadium = polyline("0 0, 100 0");
  const Polyline bend = arc({100, 10}, 10, -std::numbers::pi / 2, std::numbers::pi / 2, 30);
  stadium.points.insert(stadium.points.end(), bend.points.begin() + 1, bend.points.end());
  stadium.points.push_back({0, 20});
  const CubicFit fit = fit_cubics(stadium, {.tolerance = 0.3});
  const Polyline flat = flatten(fit.path, 0.01).at(0).polyline;
  for (const Point p : flat.points) {
    if (p.x > 98) continue;
    EXPECT_LT(std::min(std::abs(p.y), std::abs(p.y - 20)), 0.45) << p.x;
  }
}

TEST(FitCubics, TakesWhateverIsThere) {
  EXPECT_TRUE(fit_cubics(Polyline{}).path.empty());
  EXPECT_EQ(to_path_data(fit_cubics(polyline("3 4")).path), "M3 4");
  EXPECT_EQ(to_path_data(fit_cubics(polyline("3 4 z")).path), "M3 4 Z");
  EXPECT_EQ(to_path_data(fit_cubics(polyline("3 4, 3 4, 3 4")).path), "M3 4");
  EXPECT_EQ(to_path_data(fit_cubics(polyline("3 4, 3 4, 9 4, 9 4")).path), "M3 4 L9 4");
  // There and back again is not a point, a loop back to its start is not a straight line.
  EXPECT_LT(fit_cubics(polyline("0 0, 9 0, 0 0 z")).error, 0.5);
  Polyline loop = circle({0, 0}, 9, 60);
  loop.closed = false;
  loop.points.push_back(loop.points.front());
  EXPECT_LT(largest_distance(loop, fit_cubics(loop).path), 0.5);
}

TEST(FitCubics, KeepsTheShapeOfWhatIsSmallerThanTheTolerance) {
  const Polyline dot = circle({5, 5}, 0.1, 30);
  const CubicFit fit = fit_cubics(dot, {.tolerance = 2});
  EXPECT_LE(fit.path.vertex_count(), 6u);
  EXPECT_LT(fit.error, 0.05);
}

TEST(FitCubics, DoesNotDependOnTheUnit) {
  for_each_seed(20, [](std::uint64_t seed) {
    Polyline curve = random_drawing(seed);
    const std::size_t expected = fit_cubics(curve, {.tolerance = 0.5}).points.size();
    for (const double scale : {0x1p-60, 0x1p60}) {
      Polyline scaled = curve;
      for (Point& p : scaled.points) p *= scale;
      ASSERT_EQ(fit_cubics(scaled, {.tolerance = 0.5 * scale}).points.size(), expected);
    }
  });
}

TEST(FitCubics, ChecksItsParametersAndPoints) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fit_cubics(polyline("0 0, 1 1"), {.tolerance = 0}), Error);
  EXPECT_THROW(fit_cubics(polyline("0 0, 1 1"), {.tolerance = nan}), Error);
  EXPECT_THROW(fit_cubics(polyline("0 0, 1 1"), {.corner_angle = -1}), Error);
  EXPECT_THROW(fit_cubics(polyline("0 0, 1 1"), {.corner_reach = -1}), Error);
  EXPECT_THROW(fit_cubics({{{0, 0}, {nan, 1}}, false}), Error);
  EXPECT_THROW(fit_cubics(polyline("0 0, 1e300 0, 0 1e300 z")), Error);
}

}  // namespace
}  // namespace libstyle
