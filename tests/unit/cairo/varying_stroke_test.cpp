// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "libstyle/geometry/flatten.h"
#include "tests/support/seeds.h"
#include "tests/unit/cairo/drawing.h"

namespace libstyle {
namespace {

PathRecord with_widths(std::string_view data, std::vector<double> widths) {
  PathRecord record = stroked(data, 1);
  record.along.channels = {{"width", std::move(widths)}};
  return record;
}

PathRecord random_scrawl(RandomValues& random, double width) {
  PathRecord record = stroked("M50 50", width);
  record.path.clear();
  const auto point = [&] { return Point{random.uniform(20, 80), random.uniform(20, 80)}; };
  record.path.move_to(point());
  for (int i = 0; i < 3; ++i) {
    if (random.chance(0.5)) {
      record.path.line_to(point());
    } else {
      record.path.cubic_to(point(), point(), point());
    }
  }
  if (random.chance(0.3)) record.path.close();
  return record;
}

// How far a point is from the path.
double distance_to(const std::vector<FlattenedSubpath>& path, Point p) {
  double least = 1e9;
  for (const FlattenedSubpath& subpath : path) {
    const std::vector<Point>& points = subpath.polyline.points;
    const std::size_t lines = points.size() - (subpath.polyline.closed ? 0 : 1);
    for (std::size_t i = 0; i < lines; ++i) {
      const Point from = points[i], to = points[(i + 1) % points.size()];
      const double t = dot(p - from, to - from) / squared_norm(to - from);
      least = std::min(least, distance(p, lerp(from, to, std::clamp(t, 0.0, 1.0))));
    }
  }
  return least;
}

// Drawn at half opacity, so that gaps and overlaps would show.
TEST(VaryingStroke, OfEvenWidthCoversWhatIsNearThePath) {
  for_each_seed(60, [](std::uint64_t seed) {
    RandomValues random(seed);
    const double radius = random.uniform(0.5, 12);
    PathRecord record = random_scrawl(random, 1);
    record.along.channels = {{"width", std::vector(record.path.vertex_count(), 2 * radius)}};
    record.style.line_cap = LineCap::kRound;
    record.style.stroke_opacity = 0.5;
    const Raster image = draw(make_page({record}));
    const auto flat = flatten(record.path, 0.01);
    const double margin = 0.8 + 0.015 * radius;  // half a pixel's diagonal; shared edges of corners
    for (std::size_t y = 0; y < 100; ++y) {
      for (std::size_t x = 0; x < 100; ++x) {
        const double d =
            distance_to(flat, {static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5});
        const int alpha = image.at(x, y)[3];
        if (std::abs(d - radius) <= margin) continue;
        // Triangles that meet may lose a few of Cairo's 255 steps of coverage to its fixed point.
        ASSERT_NEAR(alpha, d < radius ? 128 : 0, 3)
            << x << " " << y << ", " << d << " from the path";
      }
    }
  });
}

TEST(VaryingStroke, OfOneColorIsThatOfNoColor) {
  for_each_seed(100, [](std::uint64_t seed) {
    RandomValues random(seed);
    PathRecord plain = random_scrawl(random, 1);
    plain.along.channels = {{"width", {}}};
    for (std::size_t i = 0; i < plain.path.vertex_count(); ++i) {
      plain.along.channels[0].values.push_back(random.uniform(0, 20));
    }
    PathRecord colored = plain;
    colored.along.colors.assign(plain.path.vertex_count(), kBlack);
    EXPECT_EQ(count_different(draw(make_page({plain})), draw(make_page({colored})), 8), 0u);
  });
}

TEST(VaryingStroke, GrowsEvenlyFromVertexToVertex) {
  const Raster image = draw(make_page({with_widths("M10 50 L90 50", {0, 40})}));
  EXPECT_EQ(count_different(image, draw(make_page({filled("M10 50 L90 30 L90 70 Z")})), 24), 0u);
}

TEST(VaryingStroke, CoversTheSectorOfAWidening) {
  const Raster image = draw(make_page({with_widths("M50 50 L50 50", {30, 30})}));
  EXPECT_EQ(covered_area(image), 0) << "butt caps draw no dot";
  PathRecord dot = with_widths("M50 50 L50 50", {30, 30});
  dot.style.line_cap = LineCap::kRound;
  EXPECT_NEAR(covered_area(draw(make_page({dot}))), 225 * std::numbers::pi, 4);
}

TEST(VaryingStroke, ColorsChangeEvenlyAlongTheCurve) {
  PathRecord record = stroked("M0 50 L100 50", 20);
  record.along.colors = {{255, 0, 0}, {0, 0, 255}};
  const Raster image = draw(make_page({record}));
  for (std::size_t x = 0; x < 100; ++x) {
    const double t = (static_cast<double>(x) + 0.5) / 100;
    EXPECT_NEAR(image.at(x, 50)[0], 255 * (1 - t), 4) << x;
    EXPECT_NEAR(image.at(x, 50)[2], 255 * t, 4) << x;
    EXPECT_EQ(image.at(x, 50)[3], 255) << x;
  }
}

TEST(VaryingStroke, AlphaAndOpacityMultiply) {
  PathRecord record = stroked("M0 50 L100 50", 20);
  record.along.colors = {{0, 0, 0, 128}, {0, 0, 0, 128}};
  record.style.stroke_opacity = 0.5;
  EXPECT_NEAR(draw(make_page({record})).at(50, 50)[3], 64, 1);
}

TEST(VaryingStroke, IsDashedAsAnEvenStrokeIs) {
  PathRecord even = stroked("M10 20 C60 20 90 50 50 80 L20 60 Z", 6);
  even.style.line_join = LineJoin::kRound;
  even.style.dash_array = {9, 4, 2};
  even.style.dash_offset = 5;
  PathRecord varying = even;
  varying.along.channels = {{"width", {6, 6, 6}}};
  EXPECT_LT(count_different(draw(make_page({even})), draw(make_page({varying})), 40), 20u);
}

}  // namespace
}  // namespace libstyle
