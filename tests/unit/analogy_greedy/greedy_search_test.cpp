// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/greedy_search.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "tests/support/matchers.h"
#include "tests/unit/analogy_greedy/curves.h"

namespace libstyle {
namespace {

// Small enough for many runs, and of several levels.
SearchParameters small_parameters() {
  SearchParameters p;
  p.samples = 200;
  p.coarsest_samples = 60;
  p.passes = 2;
  return p;
}

const SampledCurve& plain() {
  static const SampledCurve curve = straight(160);
  return curve;
}
const SampledCurve& wavy() {
  static const SampledCurve curve = wave(160, 16, 3);
  return curve;
}
const SampledCurve& hill() {
  static const SampledCurve curve = with_length_parameter(wave(100, 140, 12).polyline);
  return curve;
}

SearchedCurve draw(const SampledCurve& a, const SampledCurve& filtered, const SampledCurve& b,
                   const SearchParameters& p, std::span<const CurveConstraint> constraints = {},
                   std::uint64_t place = 0) {
  const SearchExample example{a, filtered};
  return GreedySearch({&example, 1}, p).draw(b, constraints, place);
}

SearchedCurve synthesize(const SampledCurve& filtered, double length, const SearchParameters& p,
                         std::span<const CurveConstraint> constraints = {}) {
  const SearchExample example{std::nullopt, filtered};
  return GreedySearch({&example, 1}, p).synthesize(length, constraints);
}

Point end_of(const SearchedCurve& drawn) { return drawn.curve.polyline.points.back(); }

// ---- Analogies ---------------------------------------------------------------------------------

TEST(GreedySearch, OfNoChangeChangesLittle) {
  SearchParameters p = small_parameters();
  p.rotate = false;
  p.shape_weight = 2;
  const SampledCurve line = moved(wave(100, 16, 3), {20, -30});
  const SearchedCurve drawn = draw(wavy(), wavy(), line, p);
  const double spacing = arc_length(wavy().polyline) / 200;
  for (std::size_t i = 0; i < drawn.curve.size(); ++i) {
    EXPECT_THAT(drawn.curve.polyline.points[i],
                PointNear(point_at_parameter(line, drawn.curve.t[i]), 2 * spacing));
  }
}

// A' = A + v gives B' = B + v.
TEST(GreedySearch, LearnsAnOffset) {
  SearchParameters p = small_parameters();
  p.rotate = false;
  p.shape_weight = 2;
  const Vector offset{3, 8};
  const SampledCurve line = moved(wave(100, 16, 3), {20, -30});
  const SearchedCurve drawn = draw(wavy(), moved(wavy(), offset), line, p);
  const double spacing = arc_length(wavy().polyline) / 200;
  for (std::size_t i = 0; i < drawn.curve.size(); ++i) {
    EXPECT_THAT(drawn.curve.polyline.points[i],
                PointNear(point_at_parameter(line, drawn.curve.t[i]) + offset, 2 * spacing));
  }
}

TEST(GreedySearch, BringsBackTheLengthOfTheStyle) {
  for_each_seed(3, [](std::uint64_t seed) {
    SearchParameters p = small_parameters();
    p.seed = seed;
    const double growth = arc_length(wavy().polyline) / arc_length(plain().polyline);
    const SearchedCurve drawn = draw(plain(), wavy(), hill(), p);
    EXPECT_NEAR(arc_length(drawn.curve.polyline) / (growth * arc_length(hill().polyline)), 1, 0.15);
  });
}

TEST(GreedySearch, MovesAndTurnsWithEverything) {
  const SearchParameters p = small_parameters();
  const SearchedCurve drawn = draw(plain(), wavy(), hill(), p);
  const auto there = [](const SampledCurve& c) { return moved(turned(c, 0.6), {31, 17}); };
  const SearchedCurve all = draw(there(plain()), there(wavy()), there(hill()), p);
  ASSERT_EQ(all.curve.size(), drawn.curve.size());
  EXPECT_LT(greatest_distance(all.curve.polyline, there(drawn.curve).polyline), 1e-9);
}

TEST(GreedySearch, TurnsWithTheLineAloneWhenItMayRotate) {
  const SearchParameters p = small_parameters();
  const SearchedCurve drawn = draw(plain(), wavy(), hill(), p);
  const SearchedCurve all = draw(plain(), wavy(), turned(hill(), 1.1), p);
  ASSERT_EQ(all.curve.size(), drawn.curve.size());
  EXPECT_LT(greatest_distance(all.curve.polyline, turned(drawn.curve, 1.1).polyline), 1e-9);
}

TEST(GreedySearch, KeepsTheDirectionOfTheExampleWhenItMayNotRotate) {
  SearchParameters p = small_parameters();
  p.rotate = false;
  const SearchedCurve drawn = draw(plain(), wavy(), hill(), p);
  const SearchedCurve all = draw(plain(), moved(wavy(), {9, 4}), moved(hill(), {0, 0}), p);
  ASSERT_EQ(all.curve.size(), drawn.curve.size());
  EXPECT_LT(greatest_distance(all.curve.polyline, moved(drawn.curve, {9, 4}).polyline), 1e-9);
}

TEST(GreedySearch, ScalesWithEverything) {
  const auto doubled = [](SampledCurve c) {
    for (Point& point : c.polyline.points) point *= 2;
    return c;
  };
  const SearchParameters p = small_parameters();
  const SearchedCurve drawn = draw(plain(), wavy(), hill(), p);
  const SearchedCurve all = draw(doubled(plain()), doubled(wavy()), doubled(hill()), p);
  ASSERT_EQ(all.curve.size(), drawn.curve.size());
  EXPECT_LT(greatest_distance(all.curve.polyline, doubled(drawn.curve).polyline), 1e-9);
}

TEST(GreedySearch, GivesTheSameBytesTwice) {
  const SearchedCurve once = draw(plain(), wavy(), hill(), small_parameters());
  EXPECT_EQ(once.curve, draw(plain(), wavy(), hill(), small_parameters()).curve);
}

TEST(GreedySearch, DiffersBySeedAndByPlace) {
  SearchParameters p = small_parameters();
  const SearchedCurve first = draw(plain(), wavy(), hill(), p);
  EXPECT_NE(first.curve, draw(plain(), wavy(), hill(), p, {}, 1).curve);
  p.seed = 2;
  EXPECT_NE(first.curve, draw(plain(), wavy(), hill(), p).curve);
}

TEST(GreedySearch, DrawsClosedCurvesClosed) {
  const SampledCurve ring = with_length_parameter(circle({50, 50}, 30, 100));
  const SearchedCurve drawn = draw(plain(), wavy(), ring, small_parameters());
  ASSERT_TRUE(drawn.curve.polyline.closed);
  const Polyline& line = drawn.curve.polyline;
  double longest = 0, sum = 0;
  for (std::size_t i = 0; i + 1 < segment_count(line); ++i) {
    const double size = distance(segment_start(line, i), segment_end(line, i));
    longest = std::max(longest, size);
    sum += size;
  }
  EXPECT_LE(distance(line.points.back(), line.points.front()), longest);
  EXPECT_GT(sum, 2 * 3.14 * 30);
}

TEST(GreedySearch, CopiesFromClosedExamplesAcrossTheirSeam) {
  const SampledCurve ring = with_length_parameter(circle({}, 25, 200));
  SampledCurve wavy_ring = ring;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double angle = 2 * std::numbers::pi * ring.t[i];
    wavy_ring.polyline.points[i] *= 1 + 0.08 * std::sin(9 * angle) + 0.03 * std::sin(2 * angle);
  }
  SearchParameters p = small_parameters();
  p.shape_weight = 2;
  const SearchedCurve drawn = draw(ring, wavy_ring, moved(ring, {100, 0}), p);
  EXPECT_TRUE(drawn.curve.polyline.closed);
  EXPECT_NEAR(arc_length(drawn.curve.polyline), arc_length(wavy_ring.polyline),
              0.15 * arc_length(wavy_ring.polyline));
}

// Two examples, each of its own offset from lines of its own direction.
TEST(GreedySearch, TakesEveryPieceFromTheExampleThatSuits) {
  SearchParameters p = small_parameters();
  p.rotate = false;
  p.shape_weight = 20;
  const SampledCurve flat = straight(160), steep = turned(straight(160), 1.3);
  const SearchExample examples[] = {{flat, moved(flat, {0, 6})}, {steep, moved(steep, {9, 0})}};
  const GreedySearch search(examples, p);
  for (const SearchedCurve::Source& source : search.draw(moved(straight(80), {5, 5})).sources) {
    EXPECT_EQ(source.example, 0);
  }
  for (const SearchedCurve::Source& source : search.draw(turned(straight(80), 1.3)).sources) {
    EXPECT_EQ(source.example, 1);
  }
}

// ---- Constraints -------------------------------------------------------------------------------

TEST(GreedySearch, MeetsHardConstraintsExactly) {
  for_each_seed(2, [](std::uint64_t seed) {
    SearchParameters p = small_parameters();
    p.seed = seed;
    const CurveConstraint constraints[] = {
        {1, {99.1, 1.7}, {}}, {0, {0.3, -2}, {}}, {0.37, {38.77, 9.3}, {}}};
    const SearchedCurve drawn = draw(plain(), wavy(), hill(), p, constraints);
    EXPECT_EQ(drawn.curve.polyline.points.front(), constraints[1].position);
    EXPECT_EQ(end_of(drawn), constraints[0].position);
    const auto at = std::ranges::find(drawn.curve.t, 0.37);
    ASSERT_NE(at, drawn.curve.t.end());
    EXPECT_EQ(drawn.curve.polyline.points[static_cast<std::size_t>(at - drawn.curve.t.begin())],
              constraints[2].position);
  });
}

TEST(GreedySearch, ComesNearerToHeavierConstraints) {
  double last = std::numeric_limits<double>::infinity();
  const Point aim{100, -8};
  for (const double weight : {0.01, 1.0, 100.0, 1e5}) {
    const CurveConstraint constraint{1, aim, weight};
    const double off =
        distance(aim, end_of(draw(plain(), wavy(), hill(), small_parameters(), {&constraint, 1})));
    EXPECT_LT(off, last) << "weight " << weight;
    last = off;
  }
  EXPECT_LT(last, 0.01);
}

// ---- Synthesis ---------------------------------------------------------------------------------

TEST(GreedySynthesis, IsAboutAsLongAsAsked) {
  for_each_seed(3, [](std::uint64_t seed) {
    SearchParameters p = small_parameters();
    p.seed = seed;
    p.rotate = false;
    const double length = 1.5 * arc_length(wavy().polyline);
    EXPECT_NEAR(arc_length(synthesize(wavy(), length, p).curve.polyline) / length, 1, 0.2);
  });
}

TEST(GreedySynthesis, CopiesRunsButNotTheWholeExample) {
  for_each_seed(2, [](std::uint64_t seed) {
    SearchParameters p = small_parameters();
    p.seed = seed;
    p.rotate = false;
    const double whole = arc_length(wavy().polyline);
    const SearchedCurve made = synthesize(wavy(), 2 * whole, p);
    std::size_t jumps = 0;
    double longest = 0, run = 0;
    for (std::size_t i = 1; i < made.sources.size(); ++i) {
      const double step = made.sources[i].length - made.sources[i - 1].length;
      const bool goes_on = step > 0 && step < 5 * whole / 200;
      jumps += goes_on ? 0 : 1;
      run = goes_on ? run + step : 0;
      longest = std::max(longest, run);
    }
    EXPECT_GT(jumps, 5);
    EXPECT_LT(static_cast<double>(jumps), 0.5 * static_cast<double>(made.sources.size()));
    EXPECT_LT(longest, 0.6 * whole);
  });
}

// The first constraint lies inside: the curve grows from it forwards and backwards.
TEST(GreedySynthesis, GrowsBothWaysFromItsConstraints) {
  SearchParameters p = small_parameters();
  p.rotate = false;
  const CurveConstraint constraints[] = {{0.4, {10, 20}, {}}, {0.8, {70, 22}, {}}};
  const SearchedCurve made = synthesize(wavy(), 150, p, constraints);
  EXPECT_EQ(made.curve.t.front(), 0);
  EXPECT_EQ(made.curve.t.back(), 1);
  EXPECT_TRUE(std::ranges::is_sorted(made.curve.t));
  for (const CurveConstraint& constraint : constraints) {
    const auto at = std::ranges::find(made.curve.t, constraint.t);
    ASSERT_NE(at, made.curve.t.end());
    EXPECT_EQ(made.curve.polyline.points[static_cast<std::size_t>(at - made.curve.t.begin())],
              constraint.position);
  }
  // Backwards it continues as forwards: the wave runs to the right.
  EXPECT_LT(made.curve.polyline.points.front().x, 10);
}

TEST(GreedySynthesis, BeginsAtAConstraintOfTheEnd) {
  const CurveConstraint constraint{1, {5, 6}, {}};
  const SearchedCurve made = synthesize(wavy(), 120, small_parameters(), {&constraint, 1});
  EXPECT_EQ(end_of(made), constraint.position);
  EXPECT_GT(arc_length(made.curve.polyline), 60);
}

// ---- Bad input ---------------------------------------------------------------------------------

void expect_error(const char* words, const std::function<void()>& work) {
  try {
    work();
    ADD_FAILURE() << "no error about: " << words;
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(words));
  }
}

TEST(GreedySearch, RefusesWhatItCannotUse) {
  const SearchParameters p = small_parameters();
  SearchParameters many = p;
  many.levels = 40;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SampledCurve broken = wavy();
  broken.polyline.points[3].x = nan;
  const SampledCurve point{{{{1, 1}, {1, 1}}, false}, {0, 1}, {}};
  const CurveConstraint torn[] = {{0.5, {0, 0}, {}}, {0.5, {9, 9}, {}}};
  const CurveConstraint outside{1.5, {0, 0}, {}};
  const CurveConstraint weightless{0.5, {0, 0}, 0.0};
  expect_error("too short", [&] { draw(plain(), wavy(), hill(), many); });
  expect_error("not finite", [&] { draw(plain(), broken, hill(), p); });
  expect_error("no length", [&] { draw(plain(), wavy(), point, p); });
  expect_error("no length", [&] { draw(point, wavy(), hill(), p); });
  expect_error("take one away", [&] { draw(plain(), wavy(), hill(), p, torn); });
  expect_error("outside 0 .. 1", [&] { draw(plain(), wavy(), hill(), p, {&outside, 1}); });
  expect_error("weight", [&] { draw(plain(), wavy(), hill(), p, {&weightless, 1}); });
  expect_error("positive", [&] { synthesize(wavy(), 0, p); });
  expect_error("no example", [&] { GreedySearch({}, p); });
}

TEST(GreedySearch, StandsRepeatedPoints) {
  SampledCurve repeated;
  for (std::size_t i = 0; i < hill().size(); ++i) {
    for (int k = 0; k < 2; ++k) {
      repeated.polyline.points.push_back(hill().polyline.points[i]);
      repeated.t.push_back(hill().t[i]);
    }
  }
  const SearchedCurve drawn = draw(plain(), wavy(), repeated, small_parameters());
  for (const Point point : drawn.curve.polyline.points) EXPECT_TRUE(is_finite(point));
}

TEST(GreedySearch, DrawsLinesShorterThanAStepOfTheCoarsestLevel) {
  const SearchedCurve drawn = draw(plain(), wavy(), straight(0.5, 3), small_parameters());
  EXPECT_GE(drawn.curve.size(), 2);
  for (const Point point : drawn.curve.polyline.points) EXPECT_TRUE(is_finite(point));
}

}  // namespace
}  // namespace libstyle
