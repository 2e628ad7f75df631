// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/shape_element.h"

#include <gtest/gtest.h>

#include <cmath>

#include "converters/svg/shapes.h"
#include "libstyle/base/random.h"
#include "libstyle/geometry/path_data.h"

namespace libstyle::svg {
namespace {

// "rect x=1 y=2"; "-" for no element.
std::string describe(std::string_view shape, const Path& path) {
  const std::optional<ShapeElement> element = shape_element(shape, path);
  if (!element) return "-";
  std::string text(element->name);
  for (const auto& [name, value] : element->attributes) {
    text += " " + std::string(name) + "=" + value;
  }
  return text;
}

TEST(ShapeElement, FindsTheShapesAgain) {
  EXPECT_EQ(describe("rect", rectangle_path({1, 2, 10.1, 20.2}, {}, {})),
            "rect x=1 y=2 width=10.1 height=20.2");
  EXPECT_EQ(describe("rect", rectangle_path({1.1, 2.2, 10, 20}, 3, 4)),
            "rect x=1.1 y=2.2 width=10 height=20 rx=3 ry=4");
  EXPECT_EQ(describe("circle", ellipse_path({50.3, 20.1}, 12.7, 12.7)),
            "circle cx=50.3 cy=20.1 r=12.7");
  EXPECT_EQ(describe("ellipse", ellipse_path({50.3, 20.1}, 12.7, 3)),
            "ellipse cx=50.3 cy=20.1 rx=12.7 ry=3");
  EXPECT_EQ(describe("line", line_path({1, 2}, {3, 4})), "line x1=1 y1=2 x2=3 y2=4");
  EXPECT_EQ(describe("polyline", polyline_path({{1, 2}, {3, 4}, {5, 6}})),
            "polyline points=1,2 3,4 5,6");
  EXPECT_EQ(describe("polygon", polygon_path({{1, 2}, {3, 4}, {5, 6}})),
            "polygon points=1,2 3,4 5,6");
}

TEST(ShapeElement, FindsNothingWhereThePathHasChanged) {
  Path path = ellipse_path({5, 5}, 2, 2);
  path.transform(Transform::rotation(1));
  EXPECT_EQ(describe("circle", path), "-");
  EXPECT_EQ(describe("rect", parse_path_data("M0 0 L10 0 L10 10 L0 11 Z")), "-");
  EXPECT_EQ(describe("rect", parse_path_data("M0 0")), "-");
  EXPECT_EQ(describe("circle", ellipse_path({5, 5}, 2, 3)), "-");
  EXPECT_EQ(describe("line", parse_path_data("M0 0 L1 1 L2 2")), "-");
  EXPECT_EQ(describe("polygon", parse_path_data("M0 0 L1 1 M2 2 L3 3 Z")), "-");
  EXPECT_EQ(describe("polygon", parse_path_data("M0 0 C1 1 2 2 3 3 Z")), "-");
  EXPECT_EQ(describe("", line_path({1, 2}, {3, 4})), "-");
  EXPECT_EQ(describe("circle", Path()), "-");
}

Transform any_scaling(std::uint64_t seed) {
  const RandomStream random(seed, 1);
  return {0.1 + 10 * random.uniform(0), 0, 0, 0.1 + 10 * random.uniform(1), 100 * random.uniform(2),
          100 * random.uniform(3)};
}

TEST(SettleShape, MakesTransformedShapesExact) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Transform map = any_scaling(seed);
    for (Path path :
         {rectangle_path({1.1, 2.2, 30.3, 40.7}, {}, {}),
          rectangle_path({1.1, 2.2, 30.3, 40.7}, 3.3, 4.1), ellipse_path({10.3, 20.1}, 5.7, 7.9)}) {
      const std::string_view shape = path.points().front().x > 15 ? "ellipse" : "rect";
      path.transform(map);
      const Path before = path;
      settle_shape(shape, path);
      EXPECT_TRUE(shape_element(shape, path)) << "seed " << seed;
      for (std::size_t i = 0; i < path.points().size(); ++i) {
        EXPECT_LT(distance(path.points()[i], before.points()[i]), 1e-9) << "seed " << seed;
      }
    }
  }
}

TEST(SettleShape, KeepsACircleRoundUnderEvenScaling) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Transform map = any_scaling(seed);
    map.d = map.a;
    Path path = ellipse_path({10.3, 20.1}, 5.7, 5.7);
    path.transform(map);
    settle_shape("circle", path);
    EXPECT_TRUE(shape_element("circle", path)) << "seed " << seed;
  }
}

TEST(SettleShape, LeavesEverythingElse) {
  for (const Path& path : {parse_path_data("M0 0 L10 0 L10 10 L0 11 Z"), parse_path_data("M0 0"),
                           Path(), parse_path_data("M0 0 L10 0 L10 10 L0 10.000001 Z")}) {
    for (const char* shape : {"rect", "circle", "ellipse", "", "line"}) {
      Path settled = path;
      settle_shape(shape, settled);
      EXPECT_EQ(settled, path) << shape;
    }
  }
}

// Coordinates with up to four decimals, as people and programs write them.
TEST(ShapeElement, GivesBackTheNumbersThatWereWritten) {
  int found = 0;
  constexpr int kCount = 500;
  for (int seed = 0; seed < kCount; ++seed) {
    const RandomStream random(static_cast<std::uint64_t>(seed), 0);
    const auto decimal = [&](std::uint64_t i) {
      return static_cast<double>(1 + random.below(i, 5000000)) / 10000;
    };
    const Path path = ellipse_path({decimal(0), decimal(1)}, decimal(2), decimal(3));
    const std::optional<ShapeElement> element = shape_element("ellipse", path);
    if (!element) continue;
    ++found;
    EXPECT_EQ(std::stod(element->attributes[0].second), decimal(0));
    EXPECT_EQ(std::stod(element->attributes[3].second), decimal(3));
  }
  EXPECT_EQ(found, kCount);
}

}  // namespace
}  // namespace libstyle::svg
