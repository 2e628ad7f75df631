// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/parameters.h"

#include <cmath>
#include <string>

#include "libstyle/base/error.h"
#include "libstyle/base/number.h"

namespace libstyle {
namespace {

void require(bool holds, const char* member, double value, const char* range) {
  if (holds && std::isfinite(value)) return;
  std::string given;
  if (std::isfinite(value)) {
    append_number(given, value);
  } else {
    given = "not a finite number";
  }
  throw Error(std::string("the parameter ") + member + " is " + given + "; give " + range);
}

}  // namespace

void validate(const CurveAnalogyParameters& p) {
  require(p.shape_weight >= 0, "shape_weight", p.shape_weight, "0 or more");
  require(p.scale > 0, "scale", p.scale, "more than 0");
  if (p.feature_size) {
    require(*p.feature_size > 0, "feature_size", *p.feature_size, "more than 0 px");
  }
  require(p.samples >= 100 && p.samples <= 20000, "samples", p.samples, "100 to 20000");
  if (p.mean_run) {
    require(*p.mean_run >= 2 && *p.mean_run <= 1000, "mean_run", *p.mean_run, "2 to 1000");
  }
  require(p.smoothing >= 0 && p.smoothing <= 4, "smoothing", p.smoothing, "0 to 4");
  require(p.smallest_scale > 0 && p.smallest_scale <= 1, "smallest_scale", p.smallest_scale,
          "more than 0, at most 1");
  require(p.corner_angle > 0 && p.corner_angle <= 180, "corner_angle", p.corner_angle,
          "more than 0, at most 180 degrees");
  validate(p.search);
}

}  // namespace libstyle
