// SPDX-License-Identifier: Apache-2.0
// Where the curves of a drawing meet: ends with ends, and ends with the middle of other curves.
//
// Drawings hardly ever snap: ends that are meant to meet lie a little apart, or run a little past
// each other. Two ends meet when they are within the tolerance; an end meets the interior of a
// curve (its own too, farther along than a few tolerances) when it is within the tolerance and no
// other end is. Ends that meet in a chain make one junction. Crossings are no junctions; see
// SegmentGrid.
//
// The automatic tolerance: 1 % of the diagonal of the box of all curves, but at most a quarter of
// the median length of the curves, so that small drawings of many strokes do not melt into one.
// (1 % brought 27 strokes of a drawn river system to one tree; found by trial.)
//
// Cost: O(n log n) in segments for well spread curves.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/geometry/polyline.h"

namespace libstyle {

enum class JunctionRole { kStart, kEnd, kInterior };

// A curve's part in a junction. For a start or end, the place is that end.
struct JunctionMember {
  std::size_t curve = 0;
  JunctionRole role = JunctionRole::kStart;
  PolylinePlace place;

  friend bool operator==(const JunctionMember&, const JunctionMember&) = default;
};

struct Junction {
  Point position;                       // the mean of its ends, or on the host's interior if any
  std::vector<JunctionMember> members;  // at least 2; ordered by curve, then place

  friend bool operator==(const Junction&, const Junction&) = default;
};

struct JunctionGraph {
  double tolerance = 0;             // the one used
  std::vector<Junction> junctions;  // ordered by their first member

  // For each curve, the indices of its junctions in the order along the curve; a junction that a
  // curve meets twice stands twice.
  std::vector<std::vector<std::size_t>> junctions_of_curve;
};

// `tolerance` in the curves' units, or 0: automatic. Closed polylines have no ends, but can be
// hosts. Polylines of fewer than 2 points take no part.
JunctionGraph find_junctions(std::span<const Polyline> curves, double tolerance = 0);

}  // namespace libstyle
