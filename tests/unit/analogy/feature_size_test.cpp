// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/feature_size.h"

#include <gmock/gmock.h>

#include <numbers>

#include "libstyle/geometry/arc_length.h"
#include "tests/support/curves.h"

namespace libstyle {
namespace {

Polyline wave(double wavelength, double amplitude, double length) {
  Polyline result;
  for (double x = 0; x <= length; x += wavelength / 40) {
    result.points.push_back({x, amplitude * std::sin(2 * std::numbers::pi * x / wavelength)});
  }
  return result;
}

double size_of(const Polyline& filtered, std::optional<double> plain = std::nullopt) {
  return find_feature_size({&filtered, 1}, plain);
}

TEST(FeatureSize, IsAboutHalfTheWavelengthOfAWave) {
  for (const double wavelength : {10.0, 20.0, 40.0}) {
    const double size = size_of(wave(wavelength, 5, 800), 800.0);
    EXPECT_GT(size, 0.25 * wavelength);
    EXPECT_LT(size, 0.75 * wavelength);
  }
}

TEST(FeatureSize, ScalesWithTheExample) {
  Polyline curve = wave(20, 5, 600);
  const double size = size_of(curve);
  for (Point& p : curve.points) p *= 3;
  EXPECT_NEAR(size_of(curve), 3 * size, 1e-5 * size);
}

TEST(FeatureSize, StaysWithinBoundsForCurvesWithoutStyle) {
  const Polyline straight = polyline("0 0, 120 0");
  EXPECT_LE(size_of(straight), 10.0);
  EXPECT_GE(size_of(straight), 0.2);
}

}  // namespace
}  // namespace libstyle
