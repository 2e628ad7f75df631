// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/rigid_alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

RigidTransform random_rigid(RandomValues& random) {
  const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
  const double x = random.uniform(-50, 50);
  return {std::cos(angle), std::sin(angle), {x, random.uniform(-50, 50)}};
}

std::vector<Point> moved(const RigidTransform& transform, const std::vector<Point>& points) {
  std::vector<Point> result;
  for (const Point point : points) result.push_back(transform(point));
  return result;
}

double residual(const RigidTransform& transform, const std::vector<Point>& source,
                const std::vector<Point>& target, const std::vector<double>& weights) {
  double sum = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    sum += weights[i] * squared_norm(transform(source[i]) - target[i]);
  }
  return sum;
}

TEST(AlignRigidly, FindsTheMotionThatMovedThePoints) {
  for_each_seed(100, [](std::uint64_t seed) {
    RandomValues random(seed);
    const std::vector<Point> source = random_scribble(random, 2 + random.below(20), 10).points;
    const RigidTransform motion = random_rigid(random);
    const RigidAlignment found = align_rigidly(source, moved(motion, source));
    ASSERT_NEAR(found.target_from_source.cosine, motion.cosine, 1e-9);
    ASSERT_NEAR(found.target_from_source.sine, motion.sine, 1e-9);
    ASSERT_NEAR(found.residual, 0, 1e-18);
  });
}

// Whatever small motion is added, the residual grows: the closed form is a minimum.
TEST(AlignRigidly, HasTheLeastWeightedResidual) {
  for_each_seed(100, [](std::uint64_t seed) {
    RandomValues random(seed);
    const std::vector<Point> source = random_scribble(random, 12, 10).points;
    const std::vector<Point> target = random_scribble(random, 12, 10).points;
    std::vector<double> weights;
    for (std::size_t i = 0; i < 12; ++i) weights.push_back(random.uniform(0, 2));
    const RigidAlignment best = align_rigidly(source, target, weights);
    ASSERT_NEAR(best.residual, residual(best.target_from_source, source, target, weights), 1e-9);
    for (int i = 0; i < 20; ++i) {
      const RigidTransform other = random_rigid(random);
      ASSERT_GE(residual(other, source, target, weights), best.residual);
      const double angle = random.normal(0.01);
      const RigidTransform nudge{
          std::cos(angle), std::sin(angle), {random.normal(0.01), random.normal(0.01)}};
      ASSERT_GE(residual(nudge * best.target_from_source, source, target, weights), best.residual);
    }
    ASSERT_GE(align_by_translation(source, target, weights).residual, best.residual);
  });
}

TEST(AlignRigidly, NeverReflects) {
  const std::vector<Point> source = polyline("0 0, 4 0, 4 1").points;
  const std::vector<Point> mirrored = polyline("0 0, 4 0, 4 -1").points;
  const RigidAlignment found = align_rigidly(source, mirrored);
  EXPECT_GT(found.residual, 0.1);
  EXPECT_EQ(found.target_from_source.to_transform().determinant() > 0, true);
}

TEST(AlignRigidly, DoesNotTurnPointsThatCoincide) {
  const std::vector<Point> source(3, {0.1, 0.2}), target(3, {0.7, -0.3});
  const RigidTransform found = align_rigidly(source, target).target_from_source;
  EXPECT_EQ(found.cosine, 1);
  EXPECT_EQ(found.sine, 0);
  EXPECT_THAT(found(source[0]), PointNear(target[0], 1e-15));
}

TEST(AlignRigidly, IgnoresPointsOfWeightZero) {
  const std::vector<Point> source = polyline("0 0, 1 0, 50 50").points;
  const std::vector<Point> target = polyline("5 5, 5 6, -9 3").points;
  const std::vector<double> weights = {1, 1, 0};
  const RigidTransform found = align_rigidly(source, target, weights).target_from_source;
  EXPECT_THAT(found({1, 0}), PointNear({5, 6}, 1e-12));
  EXPECT_NEAR(found.sine, 1, 1e-12);
}

TEST(AlignRigidly, LosesNothingFarFromTheOrigin) {
  const Vector far{1e8, -1e8};
  std::vector<Point> source, target;
  for (const Point point : polyline("0 0, 1 0, 0 2").points) {
    source.push_back(point + far);
    target.push_back(Point{-point.y, point.x} + far);
  }
  const RigidTransform found = align_rigidly(source, target).target_from_source;
  EXPECT_NEAR(found.cosine, 0, 1e-12);
  EXPECT_NEAR(found.sine, 1, 1e-12);
}

TEST(AlignByTranslation, MovesMeanToMean) {
  const RigidAlignment found =
      align_by_translation(polyline("0 0, 2 0").points, polyline("5 5, 5 7").points);
  EXPECT_EQ(found.target_from_source.translation, (Vector{4, 6}));
  EXPECT_EQ(found.residual, 4);
}

TEST(RigidTransform, InverseAndProductUndoEachOther) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    const RigidTransform a = random_rigid(random), b = random_rigid(random);
    const Point point{random.uniform(-9, 9), random.uniform(-9, 9)};
    ASSERT_THAT(inverse(a)(a(point)), PointNear(point, 1e-12));
    ASSERT_THAT((a * b)(point), PointNear(a(b(point)), 1e-12));
    ASSERT_THAT(a.to_transform()(point), PointNear(a(point), 1e-12));
  });
}

TEST(RotationBetween, TurnsOneDirectionToTheOtherAboutTheCenter) {
  const RigidTransform turn = rotation_between({2, 0}, {0, 1e-200}, {1, 1});
  EXPECT_THAT(turn({2, 1}), PointNear({1, 2}, 1e-12));
  EXPECT_THAT(turn({1, 1}), PointNear({1, 1}, 1e-12));
}

}  // namespace
}  // namespace libstyle
