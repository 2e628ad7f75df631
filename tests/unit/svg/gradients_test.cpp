// SPDX-License-Identifier: Apache-2.0
// Gradients, from their elements to records.
#include <gmock/gmock.h>

#include "tests/unit/svg/reading.h"

namespace libstyle::svg {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kStops = "<stop stop-color='red'/><stop offset='1' stop-color='blue'/>";
const std::string kSquare = "<rect x='10' y='20' width='40' height='60' fill='url(#g) lime'/>";

// The one gradient, which the one path is filled with.
GradientRecord gradient_of(const Reading& reading) {
  const std::vector<const GradientRecord*> gradients = reading.gradients();
  EXPECT_EQ(gradients.size(), 1u);
  if (gradients.empty()) return {};
  EXPECT_EQ(reading.path().style.fill, Paint(PaintReference{gradients[0]->id}));
  return *gradients[0];
}

// What the square is filled with instead.
std::optional<Paint> fill_of(const std::string& gradients, const std::string& shape = kSquare) {
  const Reading reading = read(gradients + shape);
  EXPECT_THAT(reading.gradients(), IsEmpty());
  return reading.path().style.fill;
}

constexpr Color kLime = {0, 255, 0, 255};

TEST(Gradients, FillTheBoundingBoxByDefault) {
  const GradientRecord linear =
      gradient_of(read("<linearGradient id='g'>" + kStops + "</linearGradient>" + kSquare));
  EXPECT_EQ(linear.id, "g");
  EXPECT_EQ(std::get<LinearGeometry>(linear.geometry), (LinearGeometry{{0, 0}, {1, 0}}));
  EXPECT_EQ(linear.page_from_gradient, (Transform{40, 0, 0, 60, 10, 20}));
  EXPECT_EQ(linear.spread, Spread::kPad);
  EXPECT_THAT(linear.stops, ElementsAre(GradientStop{0, {255, 0, 0, 255}, 1},
                                        GradientStop{1, {0, 0, 255, 255}, 1}));

  const GradientRecord radial = gradient_of(
      read("<radialGradient id='g' fx='25%'>" + kStops + "</radialGradient>" + kSquare));
  EXPECT_EQ(std::get<RadialGeometry>(radial.geometry),
            (RadialGeometry{{0.5, 0.5}, {0.25, 0.5}, 0.5, 0}));
}

TEST(Gradients, StandInUserSpaceWhenAskedTo) {
  const GradientRecord gradient = gradient_of(
      read("<linearGradient id='g' gradientUnits='userSpaceOnUse' x1='5' x2='50%' y2='1in'"
           " gradientTransform='rotate(90)' spreadMethod='repeat'>" +
           kStops + "</linearGradient><g transform='translate(7 8)'>" + kSquare + "</g>"));
  EXPECT_EQ(std::get<LinearGeometry>(gradient.geometry), (LinearGeometry{{5, 0}, {50, 96}}));
  EXPECT_EQ(gradient.page_from_gradient, (Transform{0, 1, -1, 0, 7, 8}));
  EXPECT_EQ(gradient.spread, Spread::kRepeat);
}

TEST(Gradients, TakeTheBoxOfTheCurveNotOfItsControls) {
  const GradientRecord gradient =
      gradient_of(read("<linearGradient id='g'>" + kStops +
                       "</linearGradient><path d='M0 0C0 40 30 40 30 0Z' fill='url(#g)'/>"));
  EXPECT_EQ(gradient.page_from_gradient, (Transform{30, 0, 0, 30, 0, 0}));
}

TEST(Gradients, InheritAlongTheirReferences) {
  const GradientRecord gradient = gradient_of(
      read("<linearGradient id='a' x1='1' x2='2' gradientUnits='userSpaceOnUse'>" + kStops +
           "</linearGradient><radialGradient id='b' xlink:href='#a' r='9' spreadMethod='reflect'/>"
           "<linearGradient id='g' href='#b' x2='3'/>" +
           kSquare));
  EXPECT_EQ(std::get<LinearGeometry>(gradient.geometry), (LinearGeometry{{1, 0}, {3, 0}}));
  EXPECT_EQ(gradient.spread, Spread::kReflect);
  EXPECT_EQ(gradient.stops.size(), 2u);
}

TEST(Gradients, ReadStopsThroughTheCascade) {
  const GradientRecord gradient = gradient_of(
      read("<style>.half { stop-opacity: .5 }</style><g color='lime'><linearGradient id='g'>"
           "<stop offset='20%' class='half' style='stop-color: rgba(1, 2, 3, .5)'/>"
           "<stop offset='.1' stop-color='currentColor'/>"
           "<stop offset='x' stop-color='red'/><stop offset='7'/></linearGradient></g>" +
           kSquare));
  EXPECT_THAT(gradient.stops,
              ElementsAre(GradientStop{0.2, {1, 2, 3, 255}, 0.25}, GradientStop{0.2, kLime, 1},
                          GradientStop{1, {0, 0, 0, 255}, 1}));
}

TEST(Gradients, AreOneRecordForShapesThatSeeTheSame) {
  const std::string user_space = "<linearGradient id='g' gradientUnits='userSpaceOnUse' x2='9'>" +
                                 kStops + "</linearGradient>";
  EXPECT_EQ(read(user_space + kSquare + kSquare).gradients().size(), 1u);
  const Reading moved = read(user_space + kSquare + "<g transform='scale(2)'>" + kSquare + "</g>");
  ASSERT_EQ(moved.gradients().size(), 2u);
  EXPECT_EQ(moved.gradients()[1]->id, "g~2");
  EXPECT_EQ(moved.paths()[1]->style.fill, Paint(PaintReference{"g~2"}));
}

TEST(Gradients, PaintStrokesToo) {
  const Reading reading = read("<linearGradient id='g'>" + kStops +
                               "</linearGradient><circle r='5' stroke='url(#g)'/>");
  EXPECT_EQ(reading.path().style.stroke, Paint(PaintReference{"g"}));
}

TEST(Gradients, FallBackWhereTheyCannotPaint) {
  const std::string stops = ">" + kStops + "</linearGradient>";
  for (const std::string& gradients :
       {std::string(), "<linearGradient id='g' href='#g'" + stops,
        "<linearGradient id='g' href='#h'/><linearGradient id='h' href='#g'" + stops,
        "<linearGradient id='g' href='#nowhere'" + stops,
        std::string("<linearGradient id='g' href='#p'/><pattern id='p'/>"),
        "<linearGradient id='g' gradientTransform='scale(0)'" + stops,
        "<linearGradient id='g' gradientUnits='userSpaceOnUse' x2='1e308in'" + stops}) {
    EXPECT_EQ(fill_of(gradients), Paint(kLime)) << gradients;
  }
  EXPECT_EQ(fill_of("<linearGradient id='g'" + stops, "<path d='M0 0H9' fill='url(#g) lime'/>"),
            Paint(kLime));
}

TEST(Gradients, WithoutStopsPaintNothing) {
  EXPECT_EQ(fill_of("<linearGradient id='g'/>"), Paint(NoPaint{}));
}

TEST(Gradients, IgnoreValuesThatAreWrong) {
  const GradientRecord gradient = gradient_of(
      read("<radialGradient id='g' r='wide' cx='left' gradientUnits='page' spreadMethod='never'"
           " gradientTransform='none'>" +
           kStops + "</radialGradient>" + kSquare));
  EXPECT_EQ(std::get<RadialGeometry>(gradient.geometry),
            (RadialGeometry{{0.5, 0.5}, {0.5, 0.5}, 0.5, 0}));
  EXPECT_EQ(gradient.page_from_gradient, (Transform{40, 0, 0, 60, 10, 20}));
}

TEST(Gradients, StopReadingAtAnAttributeThatIsWrong) {
  const GradientRecord common = gradient_of(read(
      "<linearGradient id='g' x1='.5' spreadMethod='x'>" + kStops + "</linearGradient>" + kSquare));
  EXPECT_EQ(std::get<LinearGeometry>(common.geometry), (LinearGeometry{{0, 0}, {1, 0}}));
  const GradientRecord order = gradient_of(read("<linearGradient id='g' x1='.5' y1='x' x2='.7'>" +
                                                kStops + "</linearGradient>" + kSquare));
  EXPECT_EQ(std::get<LinearGeometry>(order.geometry), (LinearGeometry{{0.5, 0}, {1, 0}}));
}

// As Cairo paints them: the mean of the ends, or of the whole where it repeats.
TEST(Gradients, WithoutLengthAreOneColor) {
  const std::string stops =
      "<stop stop-color='#00f'/><stop offset='.5' stop-color='#f00'/>"
      "<stop offset='1' stop-color='#00f'/></linearGradient>";
  EXPECT_EQ(fill_of("<linearGradient id='g' x2='0'>" + kStops + "</linearGradient>"),
            Paint(Color{128, 0, 128, 255}));
  EXPECT_EQ(fill_of("<linearGradient id='g' x2='0'>" + stops), Paint(Color{0, 0, 255, 255}));
  for (const std::string spread : {"repeat", "reflect"}) {
    EXPECT_EQ(fill_of("<linearGradient id='g' x2='0' spreadMethod='" + spread + "'>" + stops),
              Paint(Color{128, 0, 128, 255}));
  }
}

TEST(Gradients, WithoutLengthGiveTheirMeanAlphaToTheFill) {
  const Reading reading = read(
      "<linearGradient id='g' x2='0'><stop stop-opacity='.5'/><stop offset='1'/>"
      "</linearGradient>" +
      kSquare);
  EXPECT_EQ(reading.path().style.fill_opacity, 0.75);
}

TEST(Gradients, WithoutRadiusPaintNothing) {
  const std::string stops = kStops + "</radialGradient>";
  EXPECT_EQ(fill_of("<radialGradient id='g' r='0'>" + stops), Paint(NoPaint{}));
  EXPECT_EQ(fill_of("<radialGradient id='g' r='0' spreadMethod='repeat'>" + stops),
            Paint(NoPaint{}));
}

TEST(Gradients, MeasureNoMovesThatLeadNowhere) {
  const GradientRecord gradient =
      gradient_of(read("<linearGradient id='g'>" + kStops +
                       "</linearGradient><path d='M9 9M0 0H10V20M99 99' fill='url(#g)'/>"));
  EXPECT_EQ(gradient.page_from_gradient, (Transform{10, 0, 0, 20, 0, 0}));
}

// The box of the square on the page is 20 wide: turned back by an eighth it is 10 sqrt(2) sqrt(2).
TEST(Gradients, MeasureTurnedShapesOnThePage) {
  const GradientRecord gradient =
      gradient_of(read("<linearGradient id='g'>" + kStops + "</linearGradient>" +
                       "<path transform='rotate(45)' d='M0 0H10V10H0z' fill='url(#g)'/>"));
  EXPECT_NEAR(norm(gradient.page_from_gradient.linear({1, 0})), 20, 1e-9);
}

TEST(Gradients, DrawNegativeRadiiWithoutTheirSign) {
  const GradientRecord gradient =
      gradient_of(read("<radialGradient id='g' r='-1'>" + kStops + "</radialGradient>" + kSquare));
  EXPECT_EQ(std::get<RadialGeometry>(gradient.geometry).radius, 1);
}

TEST(Gradients, SayWhenAReferenceLeadsNowhere) {
  const Reading reading =
      read("<linearGradient id='g' href='#nowhere'/><rect width='1' height='1' fill='url(#g)'/>");
  EXPECT_THAT(reading.warning_texts(), ElementsAre(HasSubstr("#g its href leads to no gradient")));
}

}  // namespace
}  // namespace libstyle::svg
