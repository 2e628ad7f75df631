// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "converters/svg/angle.h"
#include "libstyle/base/random.h"

namespace libstyle::svg {
namespace {

constexpr double kPi = std::numbers::pi;

Path arc_path(const Arc& arc) {
  Path path;
  path.move_to(arc.start);
  append_arc(path, arc);
  return path;
}

// Points along the cubics of a path, evenly in t, both ends included.
std::vector<Point> sampled(const Path& path) {
  std::vector<Point> result;
  const auto points = path.points();
  for (std::size_t i = 0; i + 3 < points.size(); i += 3) {
    for (int step = 0; step <= 32; ++step) {
      const double t = step / 32.0;
      const Point a = lerp(points[i], points[i + 1], t), b = lerp(points[i + 1], points[i + 2], t);
      const Point c = lerp(points[i + 2], points[i + 3], t);
      result.push_back(lerp(lerp(a, b, t), lerp(b, c, t), t));
    }
  }
  return result;
}

// How far it is round `center` from the first point to the last, clockwise positive.
double swept_angle(const std::vector<Point>& points, Point center) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vector a = points[i - 1] - center, b = points[i] - center;
    sum += std::atan2(cross(a, b), dot(a, b));
  }
  return sum;
}

// An arc made from its centre: the other way round than the SVG syntax has it.
struct CenteredArc {
  Point center;
  double radius_x, radius_y, rotation, start, sweep;  // angles in degrees

  Point at(double degrees) const {
    const Vector unit = unit_vector_at(degrees), axis = unit_vector_at(rotation);
    const Vector v = {radius_x * unit.x, radius_y * unit.y};
    return center + Vector{axis.x * v.x - axis.y * v.y, axis.y * v.x + axis.x * v.y};
  }
  Vector to_unit(Point p) const {
    const Vector axis = unit_vector_at(rotation), v = p - center;
    return {dot(axis, v) / radius_x, cross(axis, v) / radius_y};
  }
  Arc arc() const {
    return {at(start), radius_x,         radius_y, rotation, std::abs(sweep) > 180,
            sweep > 0, at(start + sweep)};
  }
};

CenteredArc random_arc(std::uint64_t seed) {
  const RandomStream random(seed, 0);
  const auto between = [&](std::uint64_t i, double low, double high) {
    return low + (high - low) * random.uniform(i);
  };
  const double sweep = between(5, 5, 355) * (random.bits(6) % 2 ? 1 : -1);
  return {{between(0, -50, 50), between(1, -50, 50)},
          between(2, 1, 100),
          between(3, 1, 100),
          between(4, -180, 180),
          between(7, -180, 180),
          sweep};
}

TEST(Arc, StaysWithinTheStatedErrorOfTheEllipse) {
  double worst = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const CenteredArc wanted = random_arc(seed);
    for (const Point& point : sampled(arc_path(wanted.arc()))) {
      const double error = norm(wanted.to_unit(point)) - 1;
      EXPECT_LT(std::abs(error), kArcError) << "seed " << seed;
      worst = std::max(worst, error);
    }
  }
  EXPECT_GT(worst, kArcError / 2) << "the bound says much more than is needed";
}

TEST(Arc, SweepsTheAngleItWasMadeFrom) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const CenteredArc wanted = random_arc(seed);
    std::vector<Point> unit;
    for (const Point& point : sampled(arc_path(wanted.arc())))
      unit.push_back(wanted.to_unit(point));
    EXPECT_NEAR(swept_angle(unit, {}), wanted.sweep / 180 * kPi, 1e-9) << "seed " << seed;
  }
}

TEST(Arc, JoinsItsPiecesSmoothly) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Path path = arc_path(random_arc(seed).arc());
    for (std::size_t i = 3; i + 1 < path.points().size(); i += 3) {
      const Vector before = path.points()[i] - path.points()[i - 1];
      const Vector after = path.points()[i + 1] - path.points()[i];
      EXPECT_NEAR(cross(normalized(before), normalized(after)), 0, 1e-9) << "seed " << seed;
      EXPECT_GT(dot(before, after), 0);
    }
  }
}

TEST(Arc, EndsExactlyAtItsEnd) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Arc arc = random_arc(seed).arc();
    EXPECT_EQ(arc_path(arc).points().back(), arc.end);
  }
}

TEST(Arc, CutsNoSlivers) {
  for (int degrees = 1; degrees < 360; ++degrees) {
    const CenteredArc wanted = {{}, 10, 10, 0, 17, static_cast<double>(degrees)};
    const std::size_t pieces = arc_path(wanted.arc()).commands().size() - 1;
    EXPECT_GE(pieces, std::ceil(degrees / 33.0)) << degrees;
    EXPECT_LE(pieces, std::floor(degrees / 16.5) + 1) << degrees;
    EXPECT_LE(pieces, 12u) << degrees;
  }
}

TEST(Arc, ScalesUpRadiiThatAreTooSmall) {
  const Path path = arc_path({{0, 0}, 1, 1, 0, false, true, {20, 0}});
  for (const Point& point : sampled(path)) {
    EXPECT_NEAR(distance(point, {10, 0}), 10, 10 * kArcError);
    EXPECT_LE(point.y, 1e-12);  // clockwise from the left end: over the top
  }
}

TEST(Arc, TakesNegativeRadiiAsPositive) {
  EXPECT_EQ(arc_path({{0, 0}, -30, -20, 10, true, false, {20, 5}}),
            arc_path({{0, 0}, 30, 20, 10, true, false, {20, 5}}));
}

TEST(Arc, IsALineForARadiusOfZero) {
  Path line;
  line.move_to({1, 2});
  line.line_to({3, 4});
  EXPECT_EQ(arc_path({{1, 2}, 0, 5, 0, false, true, {3, 4}}), line);
  EXPECT_EQ(arc_path({{1, 2}, 5, 0, 0, false, true, {3, 4}}), line);
}

TEST(Arc, IsNothingBetweenEqualPoints) {
  EXPECT_EQ(arc_path({{1, 2}, 5, 5, 0, true, true, {1, 2}}).commands().size(), 1u);
}

TEST(Arc, StaysFiniteForAnyRadii) {
  for (const double radius : {1e-320, 1e-160, 1e160, 1e300, 1.7e308}) {
    for (const double end : {1e-300, 1.0, 1e300}) {
      const Path path = arc_path({{0, 0}, radius, 1, 30, true, true, {end, end}});
      for (const Point& point : path.points())
        EXPECT_TRUE(is_finite(point)) << radius << " " << end;
      EXPECT_EQ(path.points().back(), (Point{end, end}));
    }
  }
}

TEST(Quarter, IsAQuarterOfTheEllipseInItsCorner) {
  Path path;
  path.move_to({5, 0});
  append_quarter(path, {5, 0}, {5, 3}, {0, 3});
  for (const Point& point : sampled(path)) {
    EXPECT_NEAR(norm({point.x / 5, point.y / 3}), 1, kArcError);
  }
  EXPECT_EQ(path.commands().size(), 4u);
  EXPECT_EQ(path.points().back(), (Point{0, 3}));
}

}  // namespace
}  // namespace libstyle::svg
