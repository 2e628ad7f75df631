// SPDX-License-Identifier: Apache-2.0
// A smooth path through a polyline: few cubic Bezier segments within a tolerance, corners kept.
//
//   CubicFit fit = fit_cubics(polyline, {.tolerance = 0.5});
//   record.path = fit.path;
//
// Stages:
//  1. Corners: vertices where the curve turns by more than corner_angle between what comes before
//     and after, seen over corner_reach of arc length on either side, so that the noise of a shaky
//     hand makes no corners (find_corners).
//  2. Spans between corners are fitted one by one. One cubic for a stretch of points, given its end
//     tangents, is the least-squares one: two unknown handle lengths, 2 x 2 normal equations,
//     points weighted by the length they stand for, then a few rounds of reparametrisation by
//     Newton's method (Schneider, "An algorithm for automatically fitting digitized curves",
//     Graphics Gems, 1990).
//  3. Where to split: not at the worst point as Schneider does, but greedily as far as one cubic
//     reaches within tolerance (doubling, then bisection), and then with the breaks moved so that
//     the segments of a span err evenly.
//  4. Tangents at breaks come from the points on both sides within corner_reach, and are shared:
//     the path is G1 everywhere but at corners.
//
// Guarantees: the path begins and ends at the first and last point, passes through every corner
// exactly, and comes within `tolerance` of every point. Handles never point backwards and are never
// longer than the arc they span, so that no loops and cusps appear that were not drawn. Two points
// give a straight line; a straight span is one L command.
//
// Cost: near linear; 1e5 points in about a second.
#pragma once

#include <cstddef>
#include <vector>

#include "libstyle/geometry/path.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

struct CubicFitParams {
  // The largest distance of a point from the path, in the curve's units. > 0.
  double tolerance = 0.5;
  // A turn sharper than this is a corner, in radians, 0 .. pi; pi: never. 45 degrees.
  double corner_angle = 0.7853981633974483;
  // The arc length on either side over which directions are measured, in the curve's units. > 0,
  // or 0: four times the tolerance. Longer: calmer, and blunter corners are missed.
  double corner_reach = 0;
};

struct CubicFit {
  Path path;
  // For each vertex of the path, the point of the polyline that it is; values at points thereby
  // become values at vertices. The vertex that closes a closed path is point 0 again, or whichever
  // the path begins with.
  std::vector<std::size_t> points;
  std::vector<bool> corners;  // for each vertex, whether the path turns sharply there; ends are not
  double error = 0;           // the largest distance of a point of the polyline from the path
};

// Repeated points are allowed, an empty polyline gives an empty path. Throws Error when a parameter
// is out of range or a point is not finite.
CubicFit fit_cubics(const Polyline& polyline, const CubicFitParams& params = {});

// The indices of the polyline's corners, as fit_cubics finds them, rising. Ends of an open polyline
// are not among them.
std::vector<std::size_t> find_corners(const Polyline& polyline, const CubicFitParams& params = {});

}  // namespace libstyle
