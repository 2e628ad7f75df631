// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/screen.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "libstyle/analogy/greedy/matching.h"
#include "tests/unit/analogy_greedy/curves.h"

namespace libstyle {
namespace {

constexpr double kTangentWeight = 100;

// Two curves compared at once, with weights 1 and 2, the first without its middle.
struct Fixture {
  NeighborhoodShape shape{binomial_weights(31, 21), 0.5};
  NeighborhoodTable first{21}, second{21};
  std::vector<Screen::Part> parts = {{&first, 1, false}, {&second, 2, true}};

  Fixture(const Polyline& a, const Polyline& b) {
    Neighborhood neighborhood(21);
    for (std::size_t i = 0; i + 1 < a.points.size(); ++i) {
      neighborhood.sample(a, {i, 0}, shape);
      first.add(neighborhood.view());
      neighborhood.sample(b, {i, 0}, shape);
      second.add(neighborhood.view());
    }
  }

  bool is_whole(std::size_t j) const {
    return first[j].begin == 0 && first[j].end == 21 && second[j].begin == 0 && second[j].end == 21;
  }

  // The least shape cost over rotations, common samples scaled up.
  double cost(std::size_t j, const NeighborhoodView& b, const NeighborhoodView& c,
              bool rotate) const {
    const Match to_b = match(first[j], b, shape, kTangentWeight);
    const Match to_c = match(second[j], c, shape, kTangentWeight);
    Vector twist = 2 * to_c.scale() * to_c.twist;
    if (!b.empty()) twist += to_b.scale() * to_b.twist;
    const Vector rotation = best_rotation(twist, rotate);
    double sum = 2 * to_c.scale() * to_c.distance_for(rotation);
    if (!b.empty()) sum += to_b.scale() * to_b.distance_for(rotation);
    return sum;
  }
};

class ScreenBounds : public testing::TestWithParam<bool> {};

// Wild curves, queries in the middle, at the ends, and beyond the end: nobody is lost.
TEST_P(ScreenBounds, AreNeverAboveTheCost) {
  const bool rotate = GetParam();
  for_each_seed(10, [&](std::uint64_t seed) {
    RandomValues random(seed);
    const Fixture fixture(with_noise(random_stroke(random, 150), random, 0.2),
                          random_stroke(random, 150));
    const Screen screen(fixture.parts, fixture.shape, kTangentWeight, rotate);
    const Polyline b = random_stroke(random, 60), c = random_stroke(random, 60);
    Neighborhood of_b(21), of_c(21);
    ScreenedPlaces screened;
    for (const std::size_t i : {0, 1, 5, 30, 57, 58}) {
      of_b.sample(b, {i, 0}, fixture.shape, false);
      if (i == 58) of_b.sample_beyond_end(b, 1, fixture.shape);
      of_c.sample(c, {i, 0}, fixture.shape);
      const NeighborhoodView query[] = {of_b.view(), of_c.view()};
      screen.lower_bounds(query, screened);
      for (std::size_t j = 0; j < fixture.first.size(); ++j) {
        if (!fixture.is_whole(j)) {
          EXPECT_EQ(screened.bounds[j], 0);
          continue;
        }
        EXPECT_LE(screened.bounds[j], fixture.cost(j, query[0], query[1], rotate) + 1e-9);
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(RotateAndTranslate, ScreenBounds, testing::Bool());

TEST(Screen, LeavesFewOfTheExample) {
  const Polyline wavy = resample(wave(150, 12, 2), 0.5).polyline;
  const Fixture fixture(wavy, wavy);
  const Screen screen(fixture.parts, fixture.shape, kTangentWeight, true);
  const Polyline line = resample(wave(60, 11, 2), 0.5).polyline;
  Neighborhood of_b(21), of_c(21);
  ScreenedPlaces screened;
  std::size_t left = 0, all = 0;
  for (std::size_t i = 20; i + 20 < line.points.size(); ++i) {
    of_b.sample(line, {i, 0}, fixture.shape, false);
    of_c.sample(line, {i, 0}, fixture.shape);
    const NeighborhoodView query[] = {of_b.view(), of_c.view()};
    screen.lower_bounds(query, screened);
    double least = 1e300;
    for (std::size_t j = 0; j < fixture.first.size(); ++j) {
      if (!fixture.is_whole(j)) continue;
      least = std::min(least, fixture.cost(j, query[0], query[1], true));
    }
    for (std::size_t j = 0; j < fixture.first.size(); ++j) {
      ++all;
      left += screened.bounds[j] > 0 && screened.bounds[j] <= 1.1 * least ? 1 : 0;
    }
  }
  EXPECT_LT(static_cast<double>(left), 0.03 * static_cast<double>(all));
}

TEST(Screen, LikesThePlaceItselfBest) {
  RandomValues random(1);
  const Polyline curve = resample(random_stroke(random, 200), 0.5);
  const Fixture fixture(curve, curve);
  const Screen screen(fixture.parts, fixture.shape, kTangentWeight, true);
  Neighborhood of_b(21), of_c(21);
  ScreenedPlaces screened;
  for (std::size_t i = 50; i < 150; i += 10) {
    of_b.sample(curve, {i, 0}, fixture.shape, false);
    of_c.sample(curve, {i, 0}, fixture.shape);
    const NeighborhoodView query[] = {of_b.view(), of_c.view()};
    screen.lower_bounds(query, screened);
    EXPECT_NEAR(static_cast<double>(screened.likeliest), static_cast<double>(i), 2);
  }
}

}  // namespace
}  // namespace libstyle
