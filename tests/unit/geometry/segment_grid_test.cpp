// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/segment_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "libstyle/base/error.h"
#include "libstyle/geometry/polygon.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<Polyline> random_drawing(std::uint64_t seed, bool lattice) {
  RandomValues random(seed);
  std::vector<Polyline> curves;
  const std::size_t count = 1 + random.below(6);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t points = 1 + random.below(20);
    curves.push_back(lattice ? random_lattice_walk(random, points, 5)
                             : random_scribble(random, points, 10));
    curves.back().closed = random.chance(0.3);
  }
  return curves;
}

struct Pair {
  CurvePlace first, second;
};

// Every pair of segments in general position, by signs of areas.
std::vector<Pair> crossings_by_brute_force(const std::vector<Polyline>& curves) {
  std::vector<Pair> result;
  const auto area = [](Point a, Point b, Point c) { return cross(b - a, c - a); };
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (std::size_t s = 0; s < segment_count(curves[i]); ++s) {
      for (std::size_t j = i; j < curves.size(); ++j) {
        for (std::size_t t = i == j ? s + 2 : 0; t < segment_count(curves[j]); ++t) {
          const bool round = curves[i].closed && s == 0 && t + 1 == segment_count(curves[i]);
          if (i == j && round) continue;
          const Point a = segment_start(curves[i], s), b = segment_end(curves[i], s);
          const Point c = segment_start(curves[j], t), d = segment_end(curves[j], t);
          if (area(a, b, c) * area(a, b, d) < 0 && area(c, d, a) * area(c, d, b) < 0) {
            result.push_back({{i, {s, 0}}, {j, {t, 0}}});
          }
        }
      }
    }
  }
  return result;
}

TEST(SegmentGrid, FindsTheCrossingsThatBruteForceFinds) {
  for_each_seed(300, [](std::uint64_t seed) {
    const std::vector<Polyline> curves = random_drawing(seed, false);
    const std::vector<Crossing> found = SegmentGrid(curves).crossings();
    const std::vector<Pair> expected = crossings_by_brute_force(curves);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_EQ(found[i].first.curve, expected[i].first.curve);
      ASSERT_EQ(found[i].first.place.segment, expected[i].first.place.segment);
      ASSERT_EQ(found[i].second.curve, expected[i].second.curve);
      ASSERT_EQ(found[i].second.place.segment, expected[i].second.place.segment);
      ASSERT_TRUE(found[i].proper);
      for (const CurvePlace& at : {found[i].first, found[i].second}) {
        ASSERT_THAT(point_at(curves[at.curve], at.place), PointNear(found[i].position, 1e-9));
      }
    }
  });
}

// With exact contacts everywhere, the rule of the header says: as if later strands were shifted.
// On a lattice of unit step a shift of (1e-4, 1e-8) is small enough to be taken literally.
TEST(SegmentGrid, DecidesContactsAsIfLaterCurvesWereShifted) {
  for_each_seed(500, [](std::uint64_t seed) {
    RandomValues random(seed);
    const Polyline a = random_lattice_walk(random, 2 + random.below(12), 5);
    const Polyline b = random_lattice_walk(random, 2 + random.below(12), 5);
    const auto between = [](const std::vector<Crossing>& all) {
      return std::ranges::count_if(
          all, [](const Crossing& c) { return c.first.curve != c.second.curve; });
    };
    Polyline shifted = b;
    for (Point& p : shifted.points) p += Vector{1e-4, 1e-8};
    const std::vector<Polyline> touching = {a, b}, apart = {a, shifted};
    ASSERT_EQ(between(SegmentGrid(touching).crossings()), between(SegmentGrid(apart).crossings()));
  });
}

TEST(SegmentGrid, ClosedCurvesCrossAnEvenNumberOfTimes) {
  for_each_seed(500, [](std::uint64_t seed) {
    RandomValues random(seed);
    std::vector<Polyline> curves = {random_lattice_walk(random, 3 + random.below(9), 5),
                                    random_lattice_walk(random, 3 + random.below(9), 5)};
    for (Polyline& curve : curves) curve.closed = true;
    std::size_t between = 0;
    for (const Crossing& crossing : SegmentGrid(curves).crossings()) {
      between += crossing.first.curve != crossing.second.curve;
    }
    ASSERT_EQ(between % 2, 0u);
  });
}

TEST(SegmentGrid, CountsPassingThroughAVertexOnce) {
  const auto count = [](const char* a, const char* b) {
    const std::vector<Polyline> curves = {polyline(a), polyline(b)};
    return SegmentGrid(curves).crossings().size();
  };
  EXPECT_EQ(count("0 0, 2 2, 4 4", "0 4, 2 2, 4 0"), 1u);  // vertex through vertex
  EXPECT_EQ(count("0 0, 4 4", "0 4, 2 2, 4 0"), 1u);       // vertex through edge
  EXPECT_EQ(count("0 0, 2 2, 2 2, 4 4", "0 4, 2 2, 2 2, 2 2, 4 0"), 1u);
  EXPECT_EQ(count("0 0, 4 0", "1 -1, 1 0, 3 0, 3 1"), 1u);       // along, then across
  EXPECT_EQ(count("0 0, 4 0", "1 -1, 1 0, 3 0, 3 -1") % 2, 0u);  // along, then back
  EXPECT_EQ(count("0 0, 4 0", "1 -1, 2 0, 3 -1") % 2, 0u);       // touching
}

TEST(SegmentGrid, CountsSelfCrossingsButNotNeighbours) {
  const auto self = [](const char* text) {
    const std::vector<Polyline> curves = {polyline(text)};
    return SegmentGrid(curves).crossings();
  };
  EXPECT_THAT(self("0 0, 4 0, 4 4 z"), IsEmpty());
  EXPECT_THAT(self("0 0, 4 0, 4 0, 4 4, 0 0, 0 0 z"), IsEmpty());
  EXPECT_THAT(self("0 0, 4 0, 2 0"), IsEmpty());  // folded back on itself
  const std::vector<Crossing> eight = self("0 0, 4 4, 4 0, 0 4 z");
  ASSERT_THAT(eight, SizeIs(1));
  EXPECT_EQ(eight[0].position, (Point{2, 2}));
  EXPECT_EQ(eight[0].first.place, (PolylinePlace{0, 0.5}));
  EXPECT_EQ(eight[0].second.place, (PolylinePlace{2, 0.5}));
  EXPECT_TRUE(eight[0].proper);
  const std::vector<Crossing> through_vertex = self("0 0, 2 2, 4 4, 4 0, 2 2, 0 4");
  ASSERT_THAT(through_vertex, SizeIs(1));
  EXPECT_FALSE(through_vertex[0].proper);
  EXPECT_EQ(through_vertex[0].position, (Point{2, 2}));
}

TEST(SegmentGrid, CrossingsWithAnotherCurveAreThoseOfADrawingWithIt) {
  for_each_seed(200, [](std::uint64_t seed) {
    std::vector<Polyline> curves = random_drawing(seed, seed % 2 == 1);
    RandomValues random(seed + 5000);
    const Polyline other = random_drawing(seed + 5000, seed % 2 == 1).front();
    const std::vector<Crossing> found = SegmentGrid(curves).crossings_with(other);
    const std::size_t last = curves.size();
    curves.push_back(other);
    std::vector<Crossing> expected = SegmentGrid(curves).crossings();
    std::erase_if(expected, [&](const Crossing& crossing) {
      return crossing.second.curve != last || crossing.first.curve == last;
    });
    ASSERT_EQ(found, expected);
  });
}

NearestPlace nearest_by_brute_force(const std::vector<Polyline>& curves, Point point) {
  NearestPlace best{{}, {}, std::numeric_limits<double>::infinity()};
  for (std::size_t curve = 0; curve < curves.size(); ++curve) {
    const std::vector<Polyline> one = {curves[curve]};
    for (const NearestPlace& place : SegmentGrid(one).within(point, 1e9)) {
      if (place.distance >= best.distance) continue;
      best = place;
      best.at.curve = curve;
    }
  }
  return best;
}

TEST(SegmentGrid, FindsTheNearestPlace) {
  for_each_seed(300, [](std::uint64_t seed) {
    const std::vector<Polyline> curves = random_drawing(seed, seed % 3 == 0);
    const SegmentGrid grid(curves);
    RandomValues random(seed + 5000);
    for (int i = 0; i < 10; ++i) {
      const double x = random.uniform(-8, 18);
      const Point point{x, random.uniform(-8, 18)};
      const NearestPlace expected = nearest_by_brute_force(curves, point);
      ASSERT_EQ(grid.nearest(point), expected);
      ASSERT_EQ(grid.nearest(point, expected.distance), expected);
      ASSERT_EQ(grid.nearest(point, expected.distance * 0.999), std::nullopt);
    }
  });
}

// Sampling each segment densely is slow, but knows nothing of grids.
TEST(SegmentGrid, WithinHoldsEverySegmentThatComesNear) {
  for_each_seed(100, [](std::uint64_t seed) {
    const std::vector<Polyline> curves = random_drawing(seed, false);
    const double radius = RandomValues(seed + 5000).uniform(0, 4);
    const Point center{5, 5};
    std::vector<NearestPlace> found = SegmentGrid(curves).within(center, radius);
    std::erase_if(found,
                  [&](const NearestPlace& p) { return curves[p.at.curve].points.size() == 1; });
    std::size_t next = 0;
    for (std::size_t curve = 0; curve < curves.size(); ++curve) {
      for (std::size_t s = 0; s < segment_count(curves[curve]); ++s) {
        double closest = std::numeric_limits<double>::infinity();
        for (int i = 0; i <= 1000; ++i) {
          closest = std::min(closest, distance(center, point_at(curves[curve], {s, i / 1000.0})));
        }
        if (std::abs(closest - radius) < 1e-2) return;  // too near to call
        if (closest > radius) continue;
        ASSERT_LT(next, found.size());
        ASSERT_EQ(found[next].at.curve, curve);
        ASSERT_EQ(found[next].at.place.segment, s);
        ASSERT_NEAR(found[next].distance, closest, 1e-2);
        ++next;
      }
    }
    ASSERT_EQ(next, found.size());
  });
}

TEST(SegmentGrid, TakesEmptyAndDegenerateDrawings) {
  const SegmentGrid none(std::span<const Polyline>{});
  EXPECT_THAT(none.crossings(), IsEmpty());
  EXPECT_THAT(none.crossings_with(polyline("0 0, 1 1")), IsEmpty());
  EXPECT_THAT(none.within({0, 0}, 9), IsEmpty());
  EXPECT_EQ(none.nearest({0, 0}), std::nullopt);
  const std::vector<Polyline> points = {polyline("1 1"), polyline("3 3, 3 3 z"), Polyline{}};
  const SegmentGrid grid(points);
  EXPECT_THAT(grid.crossings(), IsEmpty());
  EXPECT_EQ(grid.nearest({9, 9})->position, (Point{3, 3}));
  const std::vector<Polyline> flat = {polyline("0 0, 9 0"), polyline("3 0, 5 0")};
  EXPECT_THAT(SegmentGrid(flat).crossings(), IsEmpty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Polyline> broken = {{{{0, 0}, {nan, 1}}, false}};
  EXPECT_THROW(SegmentGrid{broken}, Error);
}

TEST(SegmentGrid, TakesHugeAndTinyDrawings) {
  for (const double scale : {1e-100, 1e-9, 1e9, 1e100}) {
    std::vector<Polyline> curves = random_drawing(7, false);
    const std::size_t expected = SegmentGrid(curves).crossings().size();
    ASSERT_GT(expected, 0u);
    for (Polyline& curve : curves) {
      for (Point& p : curve.points) p *= scale;
    }
    EXPECT_EQ(SegmentGrid(curves).crossings().size(), expected) << scale;
  }
}

}  // namespace
}  // namespace libstyle
