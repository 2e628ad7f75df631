// SPDX-License-Identifier: Apache-2.0
// A smooth path through a polyline: few cubic Bezier segments within a tolerance, corners kept.
//
//   CubicFit fit = fit_cubics(polyline, {.tolerance = 0.5});
//   record.path = fit.path;
//
// Stages:
//  1. Corners are found (corners.h) and cut the curve into spans, each fitted by itself.
//  2. At every vertex where a segment may end, position and direction come from a polynomial
//     fitted to what is on both sides (local_fit.h): a break does not copy the noise of its point,
//     and both segments that meet there share its direction.
//  3. A segment reaches as far as one cubic stays within the tolerance (cubic_segment_fit.h), found
//     by doubling and bisection, instead of splitting at the worst point (Schneider, "An algorithm
//     for automatically fitting digitized curves", Graphics Gems, 1990), where an outlier decides.
//  4. The least tolerance for which so many segments suffice is found by bisection, so that the
//     segments of a span err evenly and none is a scrap.
//
// Long edges are held to the tolerance along their length as well, as the chords of arcs no more
// bent than the calmer of their ends; an edge far longer than its neighbours is straight.
//
// Guarantees: the path begins and ends at the first and last point and passes through every corner
// exactly, and where it is asked to; no point is farther from it than `error`, which is at most
// `tolerance`; no segment has a loop or a cusp. It is smooth (G1) but at corners and where
// neighbouring points go backwards. A span that stays within half the tolerance of its chord is one
// L command.
//
// Cost: near linear; 1e5 points in less than a second.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/geometry/path.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

struct CubicFitParams {
  // The largest distance of a point from the path, in the curve's units. > 0. Noise is smoothed
  // away if all of it stays within: four times its standard deviation.
  double tolerance = 0.5;
  // A turn sharper than this is a corner, in radians, 0 .. pi; pi: never. 45 degrees.
  double corner_angle = 0.7853981633974483;
  // The arc length on either side over which directions are measured, in the curve's units. > 0,
  // or 0: four times the tolerance. Longer: calmer, and blunter corners are missed.
  double corner_reach = 0;
};

struct CubicFit {
  Path path;
  // For each vertex of the path, the point of the polyline it stands for: values at points thereby
  // become values at vertices. A closed path may end at the point it began with, then closed by Z.
  std::vector<std::size_t> points;
  std::vector<bool> corners;  // for each vertex, whether it is a corner; ends are not
  double error = 0;           // the largest distance of a point of the polyline from the path
};

// Repeated points are allowed; an empty polyline gives an empty path, one point an M alone. Closed
// paths begin at their first corner or, without corners, near the first point. Throws Error when a
// parameter is out of range or a point is not finite.
//
// At the points `through`, rising, there are vertices in exactly their places, and no corners for
// it; of points that repeat the one before them only the first can be asked for.
CubicFit fit_cubics(const Polyline& polyline, const CubicFitParams& params = {},
                    std::span<const std::size_t> through = {});

}  // namespace libstyle
