// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/rounded_corners.h"

#include <gtest/gtest.h>

#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/gaussian.h"
#include "tests/support/curves.h"

namespace libstyle {
namespace {

constexpr double kFeature = 10;

SampledCurve sampled(Polyline curve, double length) {
  SampledCurve result = with_length_parameter(curve);
  for (double& t : result.t) t *= length;
  return result;
}

Polyline with_many_vertices(const Polyline& curve) {
  return resample(with_length_parameter(curve), 0.25).polyline;
}

TEST(RoundedCorners, FindsHowMuchACornerWasBlurred) {
  for (const char* corner : {"0 0, 100 0, 100 100", "0 0, 100 0, 20 60", "0 0, 100 0, 180 60"}) {
    for (const double sigma : {2.0, 4.0, 6.0}) {
      const Polyline plain = with_many_vertices(polyline(corner));
      const Polyline filtered = gaussian_blur(plain, sigma);
      const RoundedCorners rounded(plain, sampled(filtered, arc_length(plain)), kFeature);
      EXPECT_NEAR(rounded.blur_at(100), sigma, 0.3 * sigma) << corner;
      EXPECT_EQ(rounded.blur_at(20), 0) << corner;
      EXPECT_EQ(rounded.blur_at(180), 0) << corner;
    }
  }
}

TEST(RoundedCorners, LeavesCornersThatAreKept) {
  for (const char* text : {"0 0, 100 0, 100 100", "0 0, 100 0, 20 60, 90 90"}) {
    const Polyline plain = with_many_vertices(polyline(text));
    const RoundedCorners rounded(plain, sampled(plain, arc_length(plain)), kFeature);
    for (double x = 0; x < arc_length(plain); x += 5) EXPECT_EQ(rounded.blur_at(x), 0);
  }
}

TEST(RoundedCorners, TakesTheSeamOfAClosedCurveForAnyPlace) {
  Polyline plain = with_many_vertices(polyline("0 0, 100 0, 100 100, 0 100, 0 0"));
  Polyline kept = plain;
  plain.points.pop_back();
  plain.closed = true;
  Polyline filtered = gaussian_blur(plain, 4);
  filtered.points.push_back(filtered.points.front());
  filtered.closed = false;
  const RoundedCorners rounded(plain, sampled(filtered, 400), kFeature);
  EXPECT_NEAR(rounded.blur_at(0), rounded.blur_at(100), 0.05 * rounded.blur_at(100));
  EXPECT_NEAR(rounded.blur_at(397), rounded.blur_at(97), 0.05 * rounded.blur_at(97));
  EXPECT_GT(rounded.blur_at(397), 2);
  EXPECT_EQ(RoundedCorners(plain, sampled(kept, 400), kFeature).blur_at(0), 0);
}

}  // namespace
}  // namespace libstyle
