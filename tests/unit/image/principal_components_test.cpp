// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/principal_components.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libstyle/base/random.h"

namespace libstyle::image {
namespace {

// n vectors with the deviations 1, 1/2, 1/4 ... along axes turned into each other.
std::vector<float> vectors(std::size_t n, std::size_t length) {
  const RandomStream random(5, 0);
  std::vector<float> result;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> v(length);
    for (std::size_t k = 0; k < length; ++k) {
      v[k] = random.normal(i * length + k) * std::pow(0.5, static_cast<double>(k));
    }
    for (std::size_t k = 0; k + 1 < length; ++k) {
      const double a = v[k], b = v[k + 1];
      v[k] = 0.8 * a - 0.6 * b;
      v[k + 1] = 0.6 * a + 0.8 * b;
    }
    for (const double x : v) result.push_back(static_cast<float>(x + 3));
  }
  return result;
}

TEST(PrincipalComponents, AreOrthonormal) {
  const PrincipalComponents found = principal_components(vectors(400, 12), 12, 6, 1);
  ASSERT_EQ(found.count, 6u);
  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = 0; b < 6; ++b) {
      double product = 0;
      for (std::size_t i = 0; i < 12; ++i) {
        product += double{found.basis[i * 6 + a]} * found.basis[i * 6 + b];
      }
      EXPECT_NEAR(product, a == b ? 1 : 0, 1e-5);
    }
  }
}

TEST(PrincipalComponents, KeepTheShareOfTheVarianceThatWasAskedFor) {
  // Of variances 1, 1/4, 1/16 ... the first two are 15/16 of all.
  const std::vector<float> data = vectors(20000, 10);
  const PrincipalComponents two = principal_components(data, 10, 10, 0.92);
  EXPECT_EQ(two.count, 2u);
  EXPECT_NEAR(two.kept_share, 15.0 / 16, 0.01);
  EXPECT_EQ(principal_components(data, 10, 10, 0.7).count, 1u);
  EXPECT_EQ(principal_components(data, 10, 3, 1).count, 3u);
}

TEST(PrincipalComponents, ThereIsOneOfVectorsThatAreAllAlike) {
  const std::vector<float> same(40, 0.5F);
  const PrincipalComponents found = principal_components(same, 4, 3, 0.99);
  EXPECT_EQ(found.count, 1u);
  for (const float value : found.basis) EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace libstyle::image
