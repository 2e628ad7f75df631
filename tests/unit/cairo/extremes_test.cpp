// SPDX-License-Identifier: Apache-2.0
// Coordinates that Cairo cannot count.
#include <gtest/gtest.h>

#include <array>

#include "tests/support/seeds.h"
#include "tests/unit/cairo/drawing.h"

namespace libstyle {
namespace {

// An extreme number, or one on the page.
double any_coordinate(RandomValues& random) {
  constexpr std::array kSizes = {1e308, 1.7e308, 1e100, 1e12, 1e9, 8.4e6, 3e5, 2e4};
  const double side = random.chance(0.5) ? 1 : -1;
  return random.chance(0.4) ? random.uniform(0, 100) : side * kSizes[random.below(kSizes.size())];
}

PathRecord extreme_path(RandomValues& random) {
  PathRecord record;
  const auto point = [&] { return Point{any_coordinate(random), any_coordinate(random)}; };
  for (int subpath = 0; subpath < 2; ++subpath) {
    record.path.move_to(point());
    for (int i = 0; i < 4; ++i) {
      if (random.chance(0.5)) {
        record.path.line_to(point());
      } else {
        record.path.cubic_to(point(), point(), point());
      }
    }
    if (random.chance(0.5)) record.path.close();
  }
  return record;
}

TEST(Extremes, AnyCoordinatesAreDrawn) {
  for_each_seed(300, [](std::uint64_t seed) {
    RandomValues random(seed);
    PathRecord record = extreme_path(random);
    record.style.fill = kRed;
    record.style.stroke = kBlack;
    record.style.stroke_width = random.chance(0.5) ? 3 : std::abs(any_coordinate(random));
    record.style.line_join = static_cast<LineJoin>(random.below(3));
    record.style.line_cap = static_cast<LineCap>(random.below(3));
    if (random.chance(0.5)) record.style.dash_array = {std::abs(any_coordinate(random)), 2};
    if (random.chance(0.3)) record.style.opacity = 0.5;
    if (random.chance(0.3)) {
      record.along.channels = {{"width", std::vector<double>(record.path.vertex_count(), 1e300)}};
    }
    EXPECT_EQ(draw(make_page({record})).width, 100u);
  });
}

TEST(Extremes, AFillBeyondAllBoundsFillsThePage) {
  for (const char* size : {"20000", "1e7", "1e12", "1e308"}) {
    const std::string s = size;
    const std::string square =
        "M-" + s + " -" + s + " L" + s + " -" + s + " L" + s + " " + s + " L-" + s + " " + s + " Z";
    EXPECT_DOUBLE_EQ(covered_area(draw(make_page({filled(square)}))), 10000) << size;
    PathRecord ring = filled(square + "M20 20 L80 20 L80 80 L20 80 Z");
    ring.style.fill_rule = FillRule::kEvenOdd;
    EXPECT_DOUBLE_EQ(covered_area(draw(make_page({ring}))), 6400) << size;
  }
}

TEST(Extremes, ALineThroughThePageIsSeenWhereverItEnds) {
  for (const char* size : {"20000", "1e7", "1e12", "1e308"}) {
    const std::string s = size;
    const Raster image = draw(make_page({stroked("M-" + s + " 50 L" + s + " 50", 4)}));
    EXPECT_NEAR(covered_area(image), 400, 0.5) << size;
  }
}

// Scaled so far that the path passes the margin, only a corner of it is on the page.
TEST(Extremes, CutPathsLookLikeWholeOnes) {
  for_each_seed(100, [](std::uint64_t seed) {
    RandomValues random(seed);
    PathRecord record;
    const auto point = [&] { return Point{random.uniform(-150, 250), random.uniform(-150, 250)}; };
    record.path.move_to(point());
    for (int i = 0; i < 5; ++i) record.path.cubic_to(point(), point(), point());
    if (random.chance(0.5)) record.path.close();
    record.style.fill = kRed;
    record.style.fill_rule = static_cast<FillRule>(random.below(2));
    record.style.stroke = kBlue;
    record.style.stroke_width = random.uniform(1, 30);
    record.style.line_join = LineJoin::kRound;
    const Raster whole = draw(make_page({record}));
    // A far point that adds no area and no line on the page sends the path through the cutting.
    record.path.move_to({1e6, 1e6});
    record.path.line_to({1e6, 1e6 + 1});
    EXPECT_LT(count_different(whole, draw(make_page({record})), 24), 25u);
  });
}

TEST(Extremes, GradientsThatCannotBeInvertedPaintNothing) {
  for (const double scale : {0.0, 1e-320, 1e308}) {
    GradientRecord gradient;
    gradient.id = "g";
    gradient.geometry = LinearGeometry{{0, 0}, {1e308, 1e308}};
    gradient.page_from_gradient = Transform::scaling(scale, scale);
    gradient.stops = {{0, kRed, 1}, {1, kBlue, 1}};
    PathRecord path = filled("M0 0 L100 0 L100 100 Z");
    path.style.fill = PaintReference{"g"};
    EXPECT_EQ(draw(make_page({gradient, path})).height, 100u);
  }
}

}  // namespace
}  // namespace libstyle
