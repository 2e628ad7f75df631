// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/gaussian.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/gaussian_pyramid.h"
#include "libstyle/geometry/rigid_alignment.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

// P of the header, anywhere: reflected through the ends or periodic.
Point extended_point(const ArcLength& along, double length) {
  const double total = along.total();
  if (along.polyline().closed) return along.point_at(length);
  const Point first = along.polyline().points.front(), last = along.polyline().points.back();
  if (length < 0) return 2 * first - extended_point(along, -length);
  if (length > total) return 2 * last - extended_point(along, 2 * total - length);
  return along.point_at(length);
}

// The integral of the header by brute force.
Point blurred_by_quadrature(const ArcLength& along, double length, double sigma) {
  constexpr int kSteps = 20000;
  const double step = 16 * sigma / kSteps;
  Point sum;
  for (int i = 0; i < kSteps; ++i) {
    const double u = -8 * sigma + (i + 0.5) * step;
    sum += step * std::exp(-u * u / (2 * sigma * sigma)) * extended_point(along, length + u);
  }
  return sum / (std::sqrt(2 * std::numbers::pi) * sigma);
}

TEST(GaussianBlur, AgreesWithTheIntegral) {
  for_each_seed(24, [](std::uint64_t seed) {
    RandomValues random(seed);
    Polyline curve = random_scribble(random, 3 + random.below(120), 10);
    curve.closed = seed % 2 == 1;
    const ArcLength along(curve);
    // From far below the spacing to about the length: both ways of computing are met.
    const double sigma = along.total() * std::pow(10, random.uniform(-3.5, -0.1));
    const Polyline blurred = gaussian_blur(curve, sigma);
    for (std::size_t i = 0; i < curve.points.size(); i += 7) {
      const Point expected = blurred_by_quadrature(along, along.cumulative()[i], sigma);
      ASSERT_THAT(blurred.points[i], PointNear(expected, 1e-4)) << "sigma " << sigma;
    }
  });
}

TEST(GaussianBlur, IsTheSameInBothWays) {
  for_each_seed(40, [](std::uint64_t seed) {
    RandomValues random(seed);
    Polyline coarse = random_scribble(random, 40, 10);
    coarse.closed = seed % 2 == 1;
    // Cutting segments changes neither curve nor blur, but makes the exact sum too dear.
    Polyline fine{{}, coarse.closed};
    constexpr std::size_t kParts = 200;
    for (std::size_t i = 0; i < segment_count(coarse); ++i) {
      for (std::size_t part = 0; part < kParts; ++part) {
        fine.points.push_back(point_at(coarse, {i, static_cast<double>(part) / kParts}));
      }
    }
    if (!coarse.closed) fine.points.push_back(coarse.points.back());
    const Polyline exact = gaussian_blur(coarse, 1.0), on_grid = gaussian_blur(fine, 1.0);
    for (std::size_t i = 0; i < coarse.points.size(); ++i) {
      ASSERT_THAT(on_grid.points[i * kParts], PointNear(exact.points[i], 1e-5));
    }
  });
}

TEST(GaussianBlur, KeepsOpenEndsAndStraightLines) {
  for_each_seed(40, [](std::uint64_t seed) {
    RandomValues random(seed);
    const double sigma = std::pow(10, random.uniform(-3, 3));
    const Polyline curve = random_stroke(random, 50);
    const Polyline blurred = gaussian_blur(curve, sigma);
    ASSERT_EQ(blurred.points.front(), curve.points.front());
    ASSERT_EQ(blurred.points.back(), curve.points.back());
    Polyline line;
    double x = 0;
    for (int i = 0; i < 50; ++i) line.points.push_back({x += random.uniform(0, 1), 0.5 * x});
    ASSERT_THAT(gaussian_blur(line, sigma), PolylineNear(line, 1e-10));
  });
}

TEST(GaussianBlur, ShrinksACircleByTheTransferFunction) {
  for (const double sigma : {0.01, 0.3, 1.0, 3.0}) {
    const Polyline blurred = gaussian_blur(circle({7, 7}, 2, 2000), sigma);
    const double radius = 2 * std::exp(-sigma * sigma / 8);
    EXPECT_THAT(blurred, PolylineNear(circle({7, 7}, radius, 2000), 2e-5)) << "sigma " << sigma;
  }
}

TEST(GaussianBlur, OfBlurIsBlurOfBothOnEvenSamples) {
  // Variances add up exactly only where blurring keeps the arc length, as on a straight carrier
  // with small waves.
  Polyline wave;
  for (int i = 0; i <= 2000; ++i) wave.points.push_back({0.05 * i, 1e-3 * std::sin(0.02 * i)});
  const Polyline twice = gaussian_blur(gaussian_blur(wave, 1.2), 1.6);
  EXPECT_THAT(twice, PolylineNear(gaussian_blur(wave, 2.0), 1e-7));
}

TEST(GaussianBlur, OfZeroChangesNothingAndOfALotLeavesNothing) {
  RandomValues random(3);
  const Polyline open = random_stroke(random, 40), closed = random_blob(random, 40);
  EXPECT_EQ(gaussian_blur(open, 0), open);
  const Polyline point = gaussian_blur(closed, 1e6);
  for (const Point p : point.points) EXPECT_THAT(p, PointNear(point.points[0], 1e-6));
  const Polyline chord = gaussian_blur(open, 1e6);
  const Vector across = normalized(open.points.back() - open.points.front());
  for (const Point p : chord.points) EXPECT_NEAR(cross(across, p - open.points.front()), 0, 1e-6);
}

TEST(GaussianBlur, MovesWithTheCurve) {
  for_each_seed(20, [](std::uint64_t seed) {
    RandomValues random(seed);
    Polyline curve = random_stroke(random, 300);
    curve.closed = seed % 2 == 1;
    const RigidTransform motion = rotation_between({1, 0}, {0.6, 0.8}, {3, -2});
    Polyline moved = curve;
    for (Point& p : moved.points) p = motion(p);
    Polyline expected = gaussian_blur(curve, 4);
    for (Point& p : expected.points) p = motion(p);
    ASSERT_THAT(gaussian_blur(moved, 4), PolylineNear(expected, 1e-10));
  });
}

TEST(GaussianBlur, TakesRepeatedPointsAndSinglePoints) {
  EXPECT_EQ(gaussian_blur(polyline("1 2"), 5), polyline("1 2"));
  EXPECT_EQ(gaussian_blur(polyline("1 2, 1 2"), 5), polyline("1 2, 1 2"));
  const Polyline blurred = gaussian_blur(polyline("0 0, 0 0, 4 0, 4 0, 4 4, 4 4"), 1);
  const Polyline once = gaussian_blur(polyline("0 0, 4 0, 4 4"), 1);
  EXPECT_THAT(blurred.points[2], PointNear(once.points[1], 1e-12));
  EXPECT_EQ(blurred.points[2], blurred.points[3]);
}

TEST(GaussianBlur, RefusesWhatCannotBeMeasured) {
  EXPECT_THROW(gaussian_blur(polyline("-1e300 0, 1e300 0"), 1), Error);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(gaussian_blur({{{0, 0}, {nan, 0}}, false}, 1), Error);
}

TEST(GaussianPyramid, GetsCoarserLevelByLevel) {
  RandomValues random(11);
  const SampledCurve curve =
      with_length_parameter(with_noise(random_stroke(random, 400), random, 0.3));
  const std::vector<double> kept = {0.123, 0.5};
  const auto levels = gaussian_pyramid(curve, {.finest_spacing = 0.5, .levels = 10}, kept);
  ASSERT_EQ(levels.size(), 10u);
  EXPECT_EQ(levels.back().sigma, 0);
  EXPECT_EQ(levels.back().spacing, 0.5);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const SampledCurve& level = levels[i].curve;
    EXPECT_EQ(level.polyline.points.front(), curve.polyline.points.front());
    EXPECT_EQ(level.polyline.points.back(), curve.polyline.points.back());
    for (const double t : kept) EXPECT_EQ(std::ranges::count(level.t, t), 1);
    if (i == 0) continue;
    EXPECT_NEAR(levels[i - 1].spacing / levels[i].spacing, 1.2, 1e-12);
    EXPECT_LT(arc_length(levels[i - 1].curve.polyline), arc_length(level.polyline));
    EXPECT_NEAR(levels[i].sigma * levels[i].sigma, levels[i].spacing * levels[i].spacing - 0.25,
                1e-12);
  }
}

}  // namespace
}  // namespace libstyle
