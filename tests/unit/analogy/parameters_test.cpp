// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/parameters.h"

#include <gmock/gmock.h>

#include <cmath>

#include "libstyle/base/error.h"

namespace libstyle {
namespace {

std::string complaint(const CurveAnalogyParameters& parameters) {
  try {
    validate(parameters);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(CurveAnalogyParameters, AreValidByDefault) { EXPECT_EQ(complaint({}), ""); }

TEST(CurveAnalogyParameters, NameTheMemberThatIsOutOfRange) {
  using testing::HasSubstr;
  CurveAnalogyParameters p;
  p.shape_weight = -1;
  EXPECT_THAT(complaint(p), HasSubstr("shape_weight is -1"));
  p = {};
  p.scale = 0;
  EXPECT_THAT(complaint(p), HasSubstr("scale is 0"));
  p = {};
  p.feature_size = std::nan("");
  EXPECT_THAT(complaint(p), HasSubstr("feature_size is not a finite number"));
  p = {};
  p.samples = 99;
  EXPECT_THAT(complaint(p), HasSubstr("samples is 99"));
  p = {};
  p.mean_run = 1;
  EXPECT_THAT(complaint(p), HasSubstr("mean_run is 1"));
  p = {};
  p.smoothing = 5;
  EXPECT_THAT(complaint(p), HasSubstr("smoothing is 5"));
  p = {};
  p.smallest_scale = 0;
  EXPECT_THAT(complaint(p), HasSubstr("smallest_scale is 0"));
  p = {};
  p.corner_angle = 200;
  EXPECT_THAT(complaint(p), HasSubstr("corner_angle is 200"));
}

}  // namespace
}  // namespace libstyle
