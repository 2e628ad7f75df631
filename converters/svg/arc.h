// SPDX-License-Identifier: Apache-2.0
// Elliptical arcs as cubic Bezier segments.
//
// Source: SVG 1.1, appendix F.6 (end points to centre, radii that are too small scaled up). An arc
// is cut into pieces of 30 degrees, with two equal ones of 16.5 to 33 at its end. A piece of angle
// a has control points at 4/3 tan(a/4) along its end tangents; it leaves the true arc, to the
// outside only, by (2/27) sin^6(a/4) / cos^2(a/4) of the radius: at most 6.8e-7 at 33
// degrees, 3.8e-7 at 30.
//
// Points come from square roots and constants, not from sine and cosine, which differ between
// machines in the last digit.
#pragma once

#include "libstyle/geometry/path.h"

namespace libstyle::svg {

// The largest distance of a piece from the true arc, as a share of the radius.
inline constexpr double kArcError = 7e-7;

struct Arc {
  Point start;
  double radius_x = 0;
  double radius_y = 0;
  double rotation_degrees = 0;  // of the ellipse's x axis
  bool large = false;           // the arc of more than 180 degrees
  bool clockwise = false;       // the sweep flag, on a page with y down
  Point end;
};

// Appends the arc to a path that stands at arc.start. A radius of 0 gives a straight line, equal
// end points give nothing (section F.6.2). The last point is arc.end exactly.
void append_arc(Path& path, const Arc& arc);

// Appends a quarter of an axis-parallel ellipse, from `start` to `end`, whose tangents there meet
// in `corner`.
void append_quarter(Path& path, Point start, Point corner, Point end);

}  // namespace libstyle::svg
