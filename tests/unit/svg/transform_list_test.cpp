// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/transform_list.h"

#include <gtest/gtest.h>

#include <cmath>

namespace libstyle::svg {
namespace {

constexpr auto read = parse_transform_attribute;
const auto read_css = [](std::string_view text) { return parse_transform_property(text); };

void expect_near(const Transform& a, const Transform& b) {
  constexpr double kTolerance = 1e-12;
  EXPECT_NEAR(a.a, b.a, kTolerance);
  EXPECT_NEAR(a.b, b.b, kTolerance);
  EXPECT_NEAR(a.c, b.c, kTolerance);
  EXPECT_NEAR(a.d, b.d, kTolerance);
  EXPECT_NEAR(a.e, b.e, kTolerance);
  EXPECT_NEAR(a.f, b.f, kTolerance);
}

TEST(TransformAttribute, ReadsEachFunction) {
  EXPECT_EQ(read("matrix(1 2 3 4 5 6)"), (Transform{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(read("translate(10,20)"), (Transform{1, 0, 0, 1, 10, 20}));
  EXPECT_EQ(read("translate(10)"), (Transform{1, 0, 0, 1, 10, 0}));
  EXPECT_EQ(read("scale(2)"), (Transform{2, 0, 0, 2, 0, 0}));
  EXPECT_EQ(read("scale(2 3)"), (Transform{2, 0, 0, 3, 0, 0}));
  EXPECT_EQ(read("rotate(90)"), (Transform{0, 1, -1, 0, 0, 0}));
  expect_near(read("skewX(45)").value(), {1, 0, 1, 1, 0, 0});
  expect_near(read("skewY(-45)").value(), {1, -1, 0, 1, 0, 0});
}

TEST(TransformAttribute, IsTheIdentityWhenEmpty) {
  EXPECT_EQ(read(""), Transform{});
  EXPECT_EQ(read("  "), Transform{});
}

TEST(TransformAttribute, AppliesTheLastFunctionFirst) {
  EXPECT_EQ(read("translate(10 0) scale(2)").value()({1, 1}), (Point{12, 2}));
  EXPECT_EQ(read("scale(2) translate(10 0)").value()({1, 1}), (Point{22, 2}));
}

TEST(TransformAttribute, RotatesAboutAPointThatStays) {
  const Transform turn = read("rotate(33, 5, 7)").value();
  const Point center = turn({5, 7});
  EXPECT_NEAR(center.x, 5, 1e-12);
  EXPECT_NEAR(center.y, 7, 1e-12);
  EXPECT_NEAR(turn.determinant(), 1, 1e-12);
  expect_near(read("rotate(33 5 7) rotate(-33 5 7)").value(), {});
}

TEST(TransformAttribute, IsFreeAboutSeparators) {
  const auto expected = read("translate(1 2) scale(3)");
  for (const char* text :
       {"translate(1 2)scale(3)", " translate ( 1 , 2 ) ,\n scale( 3 ) ", "translate(1,2),scale(3)",
        "translate(1+2)scale(3)", "translate(1 2) scale(3),", "translate(1 2) scale(3"}) {
    EXPECT_EQ(read(text), expected) << text;
  }
}

TEST(TransformAttribute, IsInvalidAsAWholeForOneFault) {
  for (const char* text : {"translate(10,10) foo",
                           "translate(1),,scale(2)",
                           "translate()",
                           "translate(1,2,3)",
                           "translate(1px)",
                           "rotate(45deg)",
                           "rotate(1,2)",
                           "rotate(1,2,3,4)",
                           "matrix(1 2 3 4 5)",
                           "scale(1,,2)",
                           "scale(,1)",
                           "scale(1,)",
                           "scale(1.)",
                           "scale(1,",
                           "Translate(1)",
                           "none",
                           ", scale(2)",
                           "translateX(1)",
                           "scale(1e308) scale(1e308)",
                           "scale(nan)"}) {
    EXPECT_EQ(read(text), std::nullopt) << text;
  }
}

TEST(TransformProperty, ReadsUnits) {
  EXPECT_EQ(read_css("translate(1px, 2px)"), (Transform{1, 0, 0, 1, 1, 2}));
  EXPECT_EQ(read_css("translateX(3px)translateY(4px)"), (Transform{1, 0, 0, 1, 3, 4}));
  EXPECT_EQ(read_css("rotate(90deg)"), (Transform{0, 1, -1, 0, 0, 0}));
  EXPECT_EQ(read_css("rotate(100grad)"), (Transform{0, 1, -1, 0, 0, 0}));
  EXPECT_EQ(read_css("scaleX(2) scaleY(3)"), (Transform{2, 0, 0, 3, 0, 0}));
  EXPECT_EQ(read_css("skew(0deg)"), Transform{});
  EXPECT_EQ(read_css("none"), Transform{});
}

TEST(TransformProperty, DoesWithoutUnits) {
  EXPECT_EQ(read_css("translate(3, 4) rotate(90)"), read("translate(3 4) rotate(90)"));
}

TEST(TransformProperty, RefusesWhatCssDoesAndTheUnitsThatLibrsvgDoesNotKnow) {
  for (const char* text :
       {"translate(1em)", "translate(1in)", "rotate(.25turn)", "translate(1px 2px)",
        "translate (1px)", "translate(50%)", "scale(2px)", "rotate(1px)", "rotate(1,2,3)",
        "translate(1px), scale(2)", "translate3d(1px,2px,3px)", "inherit"}) {
    EXPECT_EQ(read_css(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace libstyle::svg
