// SPDX-License-Identifier: Apache-2.0
// Arc length along a polyline: how far along a place is, and which place is so far along.
//
//   const ArcLength along(curve);
//   Point middle = along.point_at(along.total() / 2);
//
// Cost: O(n) to prepare, O(log n) a query.
#pragma once

#include <span>
#include <vector>

#include "libstyle/geometry/polyline.h"

namespace libstyle {

// The length from the first point to each point, 0 first. A closed polyline has one entry more: the
// whole length, back at the first point. Empty for an empty polyline.
std::vector<double> cumulative_lengths(const Polyline& polyline);

double arc_length(const Polyline& polyline);

// The table of one polyline, which it copies. The polyline has at least one point.
class ArcLength {
 public:
  explicit ArcLength(Polyline polyline);

  const Polyline& polyline() const { return polyline_; }
  double total() const { return cumulative_.back(); }
  // As cumulative_lengths.
  std::span<const double> cumulative() const { return cumulative_; }

  // The length from the first point to a place.
  double length_to(PolylinePlace place) const;

  // The place at a length. A length outside 0 .. total() means the nearer end of an open polyline;
  // on a closed one it goes round. At a vertex the place is the beginning of the segment that has a
  // length; at total() of an open polyline it is the end of the last segment.
  PolylinePlace place_at(double length) const;

  Point point_at(double length) const { return libstyle::point_at(polyline_, place_at(length)); }

  // The unit vector along the segment at a length; {0, 0} where the polyline has no length.
  Vector tangent_at(double length) const;

 private:
  Polyline polyline_;
  std::vector<double> cumulative_;
};

}  // namespace libstyle
