// SPDX-License-Identifier: Apache-2.0
// The curve that the algorithms work on: a list of points joined by straight lines.
#pragma once

#include <vector>

#include "libstyle/geometry/point.h"

namespace libstyle {

// A closed polyline also joins its last point to its first, and does not repeat the first.
struct Polyline {
  std::vector<Point> points;
  bool closed = false;

  friend bool operator==(const Polyline&, const Polyline&) = default;
};

}  // namespace libstyle
