// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/soft_constraints.h"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "tests/support/matchers.h"
#include "tests/support/seeds.h"

namespace libstyle {
namespace {

constexpr Stiffness kStiffness{12, 30};

std::vector<Pull> random_pulls(RandomValues& random) {
  std::vector<Pull> pulls;
  double length = 0;
  for (std::size_t i = 0; i <= random.below(8); ++i) {
    length += std::pow(10, random.uniform(-4, 2));
    Pull pull{length, {random.normal(20), random.normal(20)}, {}};
    if (random.chance(0.7)) pull.weight = std::pow(10, random.uniform(-4, 4));
    pulls.push_back(pull);
  }
  return pulls;
}

TEST(SoftConstraints, OneBringsTheLineNearerByItsShare) {
  const Pull pull{40, {30, -10}, 0.01};
  const double share = 144 / (144 + 1 / 0.01);
  EXPECT_THAT(yielding_offsets({&pull, 1}, kStiffness)[0], PointNear(share * pull.offset, 1e-12));
}

TEST(SoftConstraints, AreTheMeanOfTheGaussianThatTheyAndTheLineMake) {
  for_each_seed(50, [](std::uint64_t seed) {
    RandomValues random(seed);
    const std::vector<Pull> pulls = random_pulls(random);
    const auto n = static_cast<Eigen::Index>(pulls.size());
    Eigen::MatrixXd covariance(n, n), measured(n, n);
    Eigen::VectorXd wanted(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Pull& a = pulls[static_cast<std::size_t>(i)];
      wanted[i] = a.offset.x;
      for (Eigen::Index j = 0; j < n; ++j) {
        const Pull& b = pulls[static_cast<std::size_t>(j)];
        covariance(i, j) = 144 * std::exp(-std::abs(a.length - b.length) / 30);
      }
    }
    measured = covariance;
    for (Eigen::Index i = 0; i < n; ++i) {
      const Pull& a = pulls[static_cast<std::size_t>(i)];
      if (a.weight) measured(i, i) += 1 / *a.weight;
    }
    const Eigen::VectorXd dense = covariance * measured.ldlt().solve(wanted);
    const std::vector<Vector> offsets = yielding_offsets(pulls, kStiffness);
    for (Eigen::Index i = 0; i < n; ++i) {
      EXPECT_NEAR(offsets[static_cast<std::size_t>(i)].x, dense[i], 1e-4);
    }
  });
}

TEST(SoftConstraints, NeverBringTheLineFartherThanTheFarthestWants) {
  for_each_seed(100, [](std::uint64_t seed) {
    RandomValues random(seed);
    const std::vector<Pull> pulls = random_pulls(random);
    double most = 0;
    for (const Pull& pull : pulls) most = std::max(most, std::abs(pull.offset.x));
    for (const std::optional<double> period : {std::optional<double>(), std::optional(500.0)}) {
      const std::vector<Vector> offsets = yielding_offsets(pulls, kStiffness, period);
      for (std::size_t i = 0; i < pulls.size(); ++i) {
        EXPECT_LE(std::abs(offsets[i].x), most * (1 + 1e-9));
        if (!pulls[i].weight) {
          EXPECT_EQ(offsets[i], pulls[i].offset);
        }
      }
    }
  });
}

TEST(SoftConstraints, OnAClosedLinePullAcrossTheSeam) {
  const Pull pulls[] = {{1, {8, 0}, {}}, {399, {0, 0}, 1e-9}};
  EXPECT_LT(yielding_offsets(pulls, kStiffness)[1].x, 0.1);
  EXPECT_GT(yielding_offsets(pulls, kStiffness, 400)[1].x, 7);
}

}  // namespace
}  // namespace libstyle
