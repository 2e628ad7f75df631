// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "libstyle/base/error.h"
#include "tests/unit/cairo/drawing.h"

namespace libstyle {
namespace {

using ::testing::Each;

constexpr const char* kLeft = "M10 10 L60 10 L60 90 L10 90 Z";
constexpr const char* kRight = "M40 10 L90 10 L90 90 L40 90 Z";
constexpr Pixel kNothing = {0, 0, 0, 0};

TEST(DrawGroup, OpacityIsOfTheMembersTogether) {
  const Raster image =
      draw(make_page({group("g", 0.5), in("g", filled(kLeft)), in("g", filled(kRight))}));
  EXPECT_EQ(image.at(20, 50), (Pixel{0, 0, 0, 128}));
  EXPECT_EQ(image.at(50, 50), image.at(20, 50));
  EXPECT_EQ(image.at(80, 50), image.at(20, 50));
  EXPECT_EQ(image.at(5, 5), kNothing);
}

TEST(DrawGroup, WithoutOpacityChangesNothing) {
  const Raster with =
      draw(make_page({group("g"), in("g", filled(kLeft)), in("g", stroked(kRight, 3))}));
  const Raster without = draw(make_page({filled(kLeft), stroked(kRight, 3)}));
  EXPECT_EQ(with, without);
}

TEST(DrawPath, PaintsWholePixelsWithCrispEdges) {
  PathRecord path = filled("M10.5 10.3 L60.4 20.8 L30 90 Z");
  path.style.crisp_edges = true;
  const Raster image = draw(make_page({path}));
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) EXPECT_EQ(image.at(x, y)[3] % 255, 0) << x << ' ' << y;
  }
}

TEST(DrawGroup, BlendsWithWhatLiesBelow) {
  GroupRecord multiply = group("m");
  multiply.blend_mode = BlendMode::kMultiply;
  const Records below = {filled(kLeft, {255, 128, 0}), filled(kRight, {255, 128, 0})};
  const Raster image =
      draw(make_page({below[0], below[1], multiply, in("m", filled(kRight, {0, 255, 255}))}));
  EXPECT_EQ(image.at(20, 50), (Pixel{255, 128, 0, 255}));
  EXPECT_EQ(image.at(80, 50), (Pixel{0, 128, 0, 255}));
}

TEST(DrawGroup, IsolatedMembersBlendWithEachOtherAlone) {
  GroupRecord isolated = group("i");
  isolated.isolated = true;
  GroupRecord multiply = group("m");
  multiply.blend_mode = BlendMode::kMultiply;
  const Raster image = draw(make_page(
      {filled(kLeft, kRed), isolated, in("i", multiply), in("m", filled(kLeft, {0, 0, 255}))}));
  EXPECT_EQ(image.at(20, 50), (Pixel{0, 0, 255, 255}));
}

TEST(DrawGroup, NestedOpacitiesMultiply) {
  const Raster image =
      draw(make_page({group("a", 0.5), in("a", group("b", 0.5)), in("b", filled(kLeft))}));
  EXPECT_NEAR(image.at(20, 50)[3], 64, 1);
}

TEST(DrawGroup, HiddenGroupsAndWhatIsInThemAreNotDrawn) {
  GroupRecord outer = group("a");
  outer.hidden = true;
  const Raster image = draw(make_page({outer, in("a", group("b", 0.5)), in("b", filled(kLeft)),
                                      in("a", filled(kLeft)), filled(kRight)}));
  EXPECT_EQ(image.at(20, 50), kNothing);
  EXPECT_EQ(image.at(80, 50), (Pixel{0, 0, 0, 255}));
}

TEST(DrawGroup, ElementsDrawTheirMembers) {
  ElementRecord element;
  element.id = "e";
  const Raster image = draw(make_page({group("g", 0.5), in("g", element), in("e", filled(kLeft))}));
  EXPECT_EQ(image.at(20, 50), (Pixel{0, 0, 0, 128}));
}

TEST(DrawGroup, MembersThatStandApartAreDrawnInTheirGroupAgain) {
  const Raster image = draw(make_page(
      {group("g", 0.5), in("g", filled(kLeft)), filled(kRight, kRed), in("g", filled(kRight))}));
  EXPECT_EQ(image.at(20, 50), (Pixel{0, 0, 0, 128}));
  EXPECT_EQ(image.at(80, 50), (Pixel{127, 0, 0, 255}));
}

TEST(DrawGroup, AMissingGroupIsWarnedAboutAndIgnored) {
  PathRecord path = in("nowhere", filled(kLeft));
  path.line = 7;
  std::vector<Warning> warnings;
  const Raster image = draw(make_page({path}), [&](const Warning& w) { warnings.push_back(w); });
  EXPECT_EQ(image.at(20, 50)[3], 255);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].place.line, 7u);
  EXPECT_THAT(warnings[0].message, ::testing::HasSubstr("\"nowhere\""));
}

Records nest(int depth, double opacity) {
  Records records;
  for (int i = 0; i < depth; ++i) {
    records.push_back(in(i == 0 ? "" : std::to_string(i - 1), group(std::to_string(i), opacity)));
  }
  records.push_back(in(std::to_string(depth - 1), filled(kLeft)));
  return records;
}

TEST(DrawGroup, AnyDepthOfGroupsIsDrawn) {
  EXPECT_EQ(draw(make_page(nest(100'000, 1))), draw(make_page({filled(kLeft)})));
}

TEST(DrawGroup, TooManyLayersWithinEachOtherAreAnError) {
  EXPECT_NO_THROW(draw(make_page(nest(900, 0.999))));
  EXPECT_THROW(draw(make_page(nest(1100, 0.999))), Error);
}

TEST(DrawPath, OpacityIsOfFillAndStrokeTogether) {
  PathRecord path = stroked(kLeft, 20);
  path.style.fill = kBlack;
  path.style.opacity = 0.5;
  const Raster image = draw(make_page({path}));
  EXPECT_EQ(image.at(15, 50), (Pixel{0, 0, 0, 128}));  // both
  EXPECT_EQ(image.at(35, 50), image.at(15, 50));       // fill alone
  EXPECT_EQ(image.at(5, 50), image.at(15, 50));        // stroke alone
}

TEST(DrawPath, FillAndStrokeOpacitiesShowThroughEachOther) {
  PathRecord path = stroked(kLeft, 20);
  path.style.fill = kBlack;
  path.style.fill_opacity = path.style.stroke_opacity = 0.5;
  const Raster image = draw(make_page({path}));
  EXPECT_EQ(image.at(35, 50), (Pixel{0, 0, 0, 128}));
  EXPECT_NEAR(image.at(15, 50)[3], 191, 1);
}

TEST(DrawPath, StrokeFirstPutsTheFillOnTop) {
  PathRecord path = stroked(kLeft, 20, kRed);
  path.style.fill = kBlue;
  EXPECT_EQ(draw(make_page({path})).at(15, 50), (Pixel{255, 0, 0, 255}));
  path.style.stroke_first = true;
  EXPECT_EQ(draw(make_page({path})).at(15, 50), (Pixel{0, 0, 255, 255}));
}

TEST(DrawPath, BareCurvesAreBlackLinesOfOnePixel) {
  PathRecord bare;
  bare.path = filled("M0 50.5 L100 50.5").path;
  const Raster image = draw(make_page({bare}));
  EXPECT_EQ(image.at(50, 50), (Pixel{0, 0, 0, 255}));
  EXPECT_DOUBLE_EQ(covered_area(image), 100);
}

TEST(DrawPath, WhatIsHiddenOrUnpaintedLeavesThePageEmpty) {
  PathRecord hidden = filled(kLeft);
  hidden.style.hidden = true;
  PathRecord unpainted = filled(kLeft);
  unpainted.style.fill = NoPaint{};
  PathRecord widthless = stroked(kLeft, 0);
  EXPECT_THAT(draw(make_page({hidden, unpainted, widthless})).pixels, Each(kNothing));
}

}  // namespace
}  // namespace libstyle
