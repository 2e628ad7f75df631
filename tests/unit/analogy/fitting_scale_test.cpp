// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/fitting_scale.h"

#include <gtest/gtest.h>

#include "tests/unit/analogy/wavy_drawing.h"

namespace libstyle {
namespace {

TEST(FittingScale, GrowsWithTheDrawing) {
  const std::vector<ExamplePair> pairs = wavy_pairs();
  Path box = parse_path_data("M0 0 L200 0 L200 100 L0 100 Z");
  const Path* const paths[] = {&box};
  const double scale = fitting_scale(paths, pairs, {});
  box.transform(Transform::scaling(3, 3));
  EXPECT_NEAR(fitting_scale(paths, pairs, {}), 3 * scale, 1e-9);
}

TEST(FittingScale, IsOneWithoutLines) { EXPECT_EQ(fitting_scale({}, wavy_pairs(), {}), 1); }

}  // namespace
}  // namespace libstyle
