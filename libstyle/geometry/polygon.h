// SPDX-License-Identifier: Apache-2.0
// Measures of the region that a list of points encloses; the last point is joined to the first.
// Cost: O(n) each.
#pragma once

#include <span>

#include "libstyle/geometry/point.h"

namespace libstyle {

// Positive when the points run clockwise on a page with y down. Parts wound twice count twice.
double signed_area(std::span<const Point> polygon);

// The centre of mass of the region. Where the area vanishes: that of the boundary, and where the
// length vanishes too, the first point. At least one point.
Point centroid(std::span<const Point> polygon);

// How many times the polygon runs clockwise (y down) round a point. Points on the boundary count as
// if they lay a little to the right and, on horizontal edges, below. Exact; see orientation.h.
int winding_number(std::span<const Point> polygon, Point point);

// By the nonzero rule.
inline bool contains(std::span<const Point> polygon, Point point) {
  return winding_number(polygon, point) != 0;
}

// The angle by which b is turned from a, -pi .. pi, clockwise (y down) positive; 0 if either is
// zero.
double turning_angle(Vector a, Vector b);

}  // namespace libstyle
