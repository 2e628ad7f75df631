// SPDX-License-Identifier: Apache-2.0
// Axis-parallel boxes.
#pragma once

#include <algorithm>
#include <limits>

#include "libstyle/geometry/point.h"

namespace libstyle {

// Empty until something is included.
struct Box {
  Point low = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  friend bool operator==(const Box&, const Box&) = default;

  bool empty() const { return !(low.x <= high.x && low.y <= high.y); }
  double width() const { return empty() ? 0 : high.x - low.x; }
  double height() const { return empty() ? 0 : high.y - low.y; }

  void include(Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  void include(const Box& other) {
    if (other.empty()) return;
    include(other.low);
    include(other.high);
  }
};

}  // namespace libstyle
