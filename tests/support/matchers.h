// SPDX-License-Identifier: Apache-2.0
// Matchers that print the values they compare.
#pragma once

#include <gmock/gmock.h>

#include <ostream>
#include <vector>

#include "libstyle/geometry/path.h"
#include "libstyle/geometry/path_data.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

inline void PrintTo(Point point, std::ostream* out) { *out << point.x << " " << point.y; }
inline void PrintTo(PolylinePlace place, std::ostream* out) {
  *out << "segment " << place.segment << " at " << place.fraction;
}
inline void PrintTo(const Path& path, std::ostream* out) { *out << to_path_data(path); }

MATCHER_P2(IsPointNear, expected, tolerance,
           "is within " + ::testing::PrintToString(tolerance) + " of " +
               ::testing::PrintToString(expected)) {
  const double apart = distance(arg, expected);
  *result_listener << "which is " << apart << " away";
  return apart <= tolerance;
}

// EXPECT_THAT(point, PointNear({1, 2}, 1e-9));
inline auto PointNear(Point expected, double tolerance) { return IsPointNear(expected, tolerance); }

// As many points, each within the tolerance, and closed alike.
MATCHER_P2(PolylineNear, expected, tolerance,
           "is within " + ::testing::PrintToString(tolerance) + " of the other polyline") {
  if (arg.closed != expected.closed) {
    *result_listener << "which is " << (arg.closed ? "closed" : "open");
    return false;
  }
  if (arg.points.size() != expected.points.size()) {
    *result_listener << "which has " << arg.points.size() << " points, not "
                     << expected.points.size();
    return false;
  }
  for (std::size_t i = 0; i < arg.points.size(); ++i) {
    const double apart = distance(arg.points[i], expected.points[i]);
    if (apart <= tolerance) continue;
    *result_listener << "whose point " << i << " is " << apart << " away";
    return false;
  }
  return true;
}

}  // namespace libstyle
