// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/polygon.h"

#include <cassert>
#include <cmath>
#include <cstddef>

#include "libstyle/geometry/orientation.h"

namespace libstyle {
namespace {

// Calls visit(start, end) for each edge, the closing one too.
template <typename Visit>
void for_each_edge(std::span<const Point> polygon, const Visit& visit) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    visit(polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0]);
  }
}

Point boundary_centroid(std::span<const Point> polygon) {
  Vector sum;
  double total = 0;
  for_each_edge(polygon, [&](Point start, Point end) {
    const double length = distance(start, end);
    sum += length * (lerp(start, end, 0.5) - polygon.front());
    total += length;
  });
  return total > 0 ? polygon.front() + sum / total : polygon.front();
}

}  // namespace

double signed_area(std::span<const Point> polygon) {
  double doubled = 0;
  for_each_edge(polygon, [&](Point start, Point end) {
    doubled += cross(start - polygon.front(), end - polygon.front());
  });
  return 0.5 * doubled;
}

Point centroid(std::span<const Point> polygon) {
  assert(!polygon.empty());
  // Triangles between the first point and each edge.
  const Point origin = polygon.front();
  Vector sum;
  double doubled = 0, length = 0;
  for_each_edge(polygon, [&](Point start, Point end) {
    const double part = cross(start - origin, end - origin);
    sum += part * ((start - origin) + (end - origin)) / 3;
    doubled += part;
    length += distance(start, end);
  });
  // An area that is all rounding error has no centre.
  if (!(std::abs(doubled) > 1e-14 * length * length)) return boundary_centroid(polygon);
  return origin + sum / doubled;
}

int winding_number(std::span<const Point> polygon, Point point) {
  int winding = 0;
  for_each_edge(polygon, [&](Point start, Point end) {
    const bool start_above = start.y <= point.y, end_above = end.y <= point.y;
    if (start_above == end_above) return;
    // The edge passes the point's height: it counts if it does so to the right of the point.
    const int side = orientation(start, end, point);
    if (start_above && side > 0) ++winding;
    if (end_above && side < 0) --winding;
  });
  return winding;
}

double turning_angle(Vector a, Vector b) {
  const double along = dot(a, b), across = cross(a, b);
  return along == 0 && across == 0 ? 0 : std::atan2(across, along);
}

}  // namespace libstyle
