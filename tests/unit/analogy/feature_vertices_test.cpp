// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/feature_vertices.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "libstyle/geometry/flatten.h"
#include "libstyle/geometry/path_segments.h"
#include "libstyle/geometry/segment_grid.h"
#include "tests/support/curves.h"

namespace libstyle {
namespace {

Polyline wave(std::size_t count) {
  Polyline curve;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 0.5 * static_cast<double>(i);
    curve.points.push_back({x, 10 * std::sin(x / 15)});
  }
  return curve;
}

// Swells at random.
std::vector<double> random_widths(RandomValues& random, std::size_t count) {
  std::vector<double> widths;
  double phase = 0;
  for (std::size_t i = 0; i < count; ++i) {
    phase += random.uniform(0, 0.2);
    widths.push_back(3 + 2 * std::sin(phase));
  }
  return widths;
}

// What is drawn at the point of the path next to `place`.
double value_at(const CubicFit& fit, const std::vector<double>& values, Point place) {
  double nearest = HUGE_VAL, value = 0;
  const std::vector<Subpath> whole = subpaths(fit.path);
  for (const PathSegment& segment : whole.front().segments) {
    for (int i = 0; i <= 200; ++i) {
      const double t = i / 200.0, off = distance(point_at(segment.curve, t), place);
      if (off >= nearest) continue;
      nearest = off;
      value = std::lerp(values[fit.points[segment.start_vertex]],
                        values[fit.points[segment.end_vertex]], t);
    }
  }
  return value;
}

TEST(FeatureVertices, KeepValuesWithinTheirTolerance) {
  for_each_seed(10, [](std::uint64_t seed) {
    RandomValues random(seed);
    const Polyline curve = wave(500);
    const std::vector<double> widths = random_widths(random, 500);
    const double tolerance = random.uniform(0.05, 0.5);
    const CubicFit fit = with_feature_vertices(fit_cubics(curve, {.tolerance = 0.01}), curve,
                                               {&widths, 1}, {&tolerance, 1});
    for (std::size_t i = 0; i < 500; ++i) {
      EXPECT_NEAR(value_at(fit, widths, curve.points[i]), widths[i], 1.2 * tolerance);
    }
  });
}

TEST(FeatureVertices, LeaveTheShapeAsItIs) {
  RandomValues random(1);
  const Polyline curve = wave(500);
  const std::vector<double> widths = random_widths(random, 500);
  const double tolerance = 0.05;
  const CubicFit before = fit_cubics(curve, {.tolerance = 0.01});
  const CubicFit after = with_feature_vertices(before, curve, {&widths, 1}, {&tolerance, 1});
  ASSERT_GT(after.points.size(), before.points.size() + 10);
  EXPECT_EQ(after.path.vertex_count(), after.points.size());
  EXPECT_TRUE(std::ranges::is_sorted(after.points));
  const FlattenedSubpath there = flatten(before.path, 1e-4).front();
  const FlattenedSubpath here = flatten(after.path, 1e-4).front();
  const SegmentGrid grid({&there.polyline, 1});
  for (const Point p : here.polyline.points) EXPECT_LT(grid.nearest(p)->distance, 2e-4);
}

TEST(FeatureVertices, AreNotNeededWhereNothingChanges) {
  const Polyline line = polyline("0 0, 10 0, 50 0, 90 0, 100 0");
  const std::vector<double> even = {3, 3.4, 5, 6.6, 7};  // changes with the length
  const double tolerance = 1e-9;
  const CubicFit fit = fit_cubics(line, {.tolerance = 0.01});
  EXPECT_EQ(with_feature_vertices(fit, line, {&even, 1}, {&tolerance, 1}).path, fit.path);
  EXPECT_EQ(with_feature_vertices(fit, line, {}, {}).path, fit.path);
}

TEST(FeatureVertices, AreThePointsThatStickOut) {
  const Polyline line = polyline("0 0, 10 0, 50 0, 90 0, 100 0");
  const std::vector<double> peak = {1, 1, 9, 1, 1};
  const double tolerance = 0.1;
  const CubicFit fit = with_feature_vertices(fit_cubics(line, {.tolerance = 0.01}), line,
                                             {&peak, 1}, {&tolerance, 1});
  EXPECT_THAT(fit.points, testing::ElementsAre(0, 1, 2, 3, 4));
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_LT(distance(fit.path.vertices()[i], line.points[i]), 1e-9);
  }
}

TEST(FeatureVertices, GoRoundClosedCurves) {
  const Polyline ring = circle({0, 0}, 50, 200);
  std::vector<double> widths;
  for (const Point p : ring.points) widths.push_back(3 + std::sin(6 * std::atan2(p.y, p.x)));
  const double tolerance = 0.1;
  const CubicFit fit = with_feature_vertices(fit_cubics(ring, {.tolerance = 0.01}), ring,
                                             {&widths, 1}, {&tolerance, 1});
  EXPECT_EQ(fit.path.commands().back(), PathCommand::kClose);
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_NEAR(value_at(fit, widths, ring.points[i]), widths[i], 1.2 * tolerance);
  }
}

}  // namespace
}  // namespace libstyle
