// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/bent_line.h"

#include <gmock/gmock.h>

#include <cmath>

#include "libstyle/geometry/arc_length.h"
#include "tests/support/curves.h"
#include "tests/support/matchers.h"

namespace libstyle {
namespace {

Point place_of(const BentLine& bent, double plain_length) {
  return ArcLength(bent.line()).point_at(bent.bent_length(plain_length));
}

TEST(BentLine, PassesWhereItIsBentTo) {
  for (const Polyline& line : {polyline("0 0, 900 0"), circle({0, 0}, 150, 80)}) {
    const ArcLength along(line);
    const Bend bends[] = {{100, {0, 30}}, {300, {}}, {420.5, {-70, 15}}};
    const BentLine bent(line, bends, 10);
    for (const Bend& bend : bends) {
      EXPECT_THAT(place_of(bent, bend.length),
                  PointNear(along.point_at(bend.length) + bend.offset, 1e-9));
    }
  }
}

TEST(BentLine, KnowsBothLengthsOfEachPlace) {
  const Bend bends[] = {{300, {20, 90}}, {700, {0, -40}}};
  const BentLine bent(polyline("0 0, 900 0"), bends, 10);
  for (double length = 0; length <= 900; length += 37) {
    EXPECT_NEAR(bent.plain_length(bent.bent_length(length)), length, 1e-9);
  }
  EXPECT_EQ(bent.plain_length(arc_length(bent.line())), 900);
}

// In whatever direction a place is drawn away, with room around it.
TEST(BentLine, NeverTurnsBack) {
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double angle = degrees * 0.017453292519943295;
    const Bend bends[] = {
        {0, {}}, {1000, {100 * std::cos(angle), 100 * std::sin(angle)}}, {2000, {}}};
    const BentLine bent(polyline("0 0, 2000 0"), bends, 10);
    for (std::size_t i = 0; i < segment_count(bent.line()); ++i) {
      EXPECT_GT(segment_end(bent.line(), i).x, segment_start(bent.line(), i).x) << degrees;
    }
  }
}

TEST(BentLine, IsAsItWasFarAway) {
  const Bend bend{200, {0, 12}};
  const BentLine bent(polyline("0 0, 3000 0"), {&bend, 1}, 10);
  EXPECT_EQ(bent.line().points.back(), (Point{3000, 0}));
  EXPECT_THAT(place_of(bent, 600), PointNear({600, 0}, 1e-9));
}

}  // namespace
}  // namespace libstyle
