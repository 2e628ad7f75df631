// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/stitch.h"

#include <gmock/gmock.h>

#include <Eigen/Dense>

#include "tests/support/matchers.h"
#include "tests/support/seeds.h"

namespace libstyle {
namespace {

struct Problem {
  std::vector<Point> anchors;
  std::vector<Vector> steps;
  std::vector<double> lengths;
  double reach = 1;
  bool closed = false;

  std::vector<Point> solve() const { return stitch(anchors, steps, lengths, reach, closed); }
};

Problem random_problem(RandomValues& random, std::size_t count, bool closed) {
  Problem problem;
  problem.closed = closed;
  problem.reach = random.uniform(0.5, 20);
  for (std::size_t i = 0; i < count; ++i)
    problem.anchors.push_back({random.normal(), random.normal()});
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
    problem.steps.push_back({random.normal(), random.normal()});
    problem.lengths.push_back(random.uniform(0.1, 3));
  }
  return problem;
}

// The minimiser as a dense least-squares problem: one row for each term of the sum.
Eigen::MatrixXd dense_solution(const Problem& problem) {
  const auto n = static_cast<Eigen::Index>(problem.anchors.size());
  const auto intervals = static_cast<Eigen::Index>(problem.steps.size());
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(3 * intervals, n);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(3 * intervals, 2);
  const auto row_of = [](Point p) { return Eigen::RowVector2d(p.x, p.y); };
  for (Eigen::Index i = 0; i < intervals; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Eigen::Index next = (i + 1) % n;
    const double stiff = std::sqrt(1 / problem.lengths[k]);
    rows(3 * i, i) = -stiff;
    rows(3 * i, next) = stiff;
    right.row(3 * i) = stiff * row_of(problem.steps[k]);
    const double held = std::sqrt(problem.lengths[k] / 2) / problem.reach;
    rows(3 * i + 1, i) = held;
    right.row(3 * i + 1) = held * row_of(problem.anchors[k]);
    rows(3 * i + 2, next) = held;
    right.row(3 * i + 2) = held * row_of(problem.anchors[static_cast<std::size_t>(next)]);
  }
  return rows.colPivHouseholderQr().solve(right);
}

TEST(Stitch, AgreesWithADenseSolution) {
  for_each_seed(40, [](std::uint64_t seed) {
    RandomValues random(seed);
    const bool closed = random.chance(0.5);
    const Problem problem = random_problem(random, 3 + random.below(20), closed);
    const std::vector<Point> points = problem.solve();
    const Eigen::MatrixXd expected = dense_solution(problem);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      EXPECT_THAT(points[i], PointNear({expected(row, 0), expected(row, 1)}, 1e-9));
    }
  });
}

TEST(Stitch, KeepsACurveWhoseStepsAgreeWithItsPlaces) {
  RandomValues random(3);
  for (const bool closed : {false, true}) {
    Problem problem = random_problem(random, 12, closed);
    for (std::size_t i = 0; i < problem.steps.size(); ++i) {
      problem.steps[i] = problem.anchors[(i + 1) % 12] - problem.anchors[i];
    }
    const std::vector<Point> points = problem.solve();
    for (std::size_t i = 0; i < 12; ++i)
      EXPECT_THAT(points[i], PointNear(problem.anchors[i], 1e-12));
  }
}

TEST(Stitch, SpreadsADisagreementOverItsReach) {
  // All places at the origin, but one step asks for a jump of 1: far away nothing moves.
  Problem problem;
  problem.anchors.assign(201, {});
  problem.steps.assign(200, {});
  problem.lengths.assign(200, 1.0);
  problem.steps[100] = {1, 0};
  problem.reach = 5;
  const std::vector<Point> points = problem.solve();
  EXPECT_NEAR(points[100].x, -0.5, 0.06);
  EXPECT_NEAR(points[101].x, 0.5, 0.06);
  EXPECT_NEAR(points[111].x / points[101].x, std::exp(-2), 0.02);
  EXPECT_LT(std::abs(points[0].x), 1e-8);
}

TEST(Stitch, LeavesASinglePoint) {
  const std::vector<Point> points = stitch(std::vector<Point>{{3, 4}}, {}, {}, 1, false);
  EXPECT_THAT(points, testing::ElementsAre(Point{3, 4}));
}

}  // namespace
}  // namespace libstyle
