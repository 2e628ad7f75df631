// SPDX-License-Identifier: Apache-2.0
// Cubic Bezier segments.
//
//   B(t) = (1-t)^3 p0 + 3 (1-t)^2 t p1 + 3 (1-t) t^2 p2 + t^3 p3,  t in [0, 1]
//
// Points, derivatives and the like are evaluated in place; functions that search (box, length) say
// how exact they are.
#pragma once

#include <utility>

#include "libstyle/geometry/box.h"
#include "libstyle/geometry/point.h"

namespace libstyle {

struct CubicBezier {
  Point p0, p1, p2, p3;

  friend bool operator==(const CubicBezier&, const CubicBezier&) = default;
};

// The straight segment at even speed.
inline CubicBezier straight_bezier(Point start, Point end) {
  return {start, lerp(start, end, 1.0 / 3), lerp(start, end, 2.0 / 3), end};
}

// By de Casteljau; exactly p0 at 0 and p3 at 1.
Point point_at(const CubicBezier& curve, double t);

// dB/dt and d2B/dt2.
Vector derivative_at(const CubicBezier& curve, double t);
Vector second_derivative_at(const CubicBezier& curve, double t);

// The unit tangent. Where the derivative vanishes (controls on an end, a cusp) it is the limit from
// inside the segment, from above at t < 1 and from below at t = 1; {0, 0} only if the whole segment
// is one point.
Vector tangent_at(const CubicBezier& curve, double t);

// Signed curvature, positive where the curve turns clockwise on a page with y down (from +x towards
// +y). Infinite or NaN where the derivative vanishes.
double curvature_at(const CubicBezier& curve, double t);

// The pieces before and after t. They share the point point_at(curve, t).
std::pair<CubicBezier, CubicBezier> split_at(const CubicBezier& curve, double t);

// The piece from t0 to t1, t0 <= t1.
CubicBezier piece_between(const CubicBezier& curve, double t0, double t1);

CubicBezier reversed(const CubicBezier& curve);

// The smallest box that holds the segment, but for rounding; it holds both ends exactly.
Box bounding_box(const CubicBezier& curve);

// The length from 0 to 1, within `tolerance` (> 0) and rounding. Five-point Gauss quadrature on
// halves, as long as the two halves differ from the whole by more than their share of the tolerance
// allows (the difference overstates the error of the halves except on segments with a cusp, where
// the recursion depth, 24, is the bound). Typically 4 to 12 evaluations of the quadrature.
double arc_length(const CubicBezier& curve, double tolerance = 1e-6);

}  // namespace libstyle
