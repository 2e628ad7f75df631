// SPDX-License-Identifier: Apache-2.0
// Where the curves of a drawing meet: ends with ends, and ends with the middle of curves.
//
// Drawings hardly ever snap: ends that are meant to meet lie a little apart, or run a little past
// each other.
//  1. Ends within the tolerance of each other meet; ends that meet in a chain make one junction. An
//     all but closed curve meets itself.
//  2. A curve takes part in a junction with its interior where it comes within the tolerance of one
//     of the junction's ends: the nearest place. What lies within three tolerances of an end of the
//     curve that is in the same junction is that end, not interior.
// Crossings are no junctions; see SegmentGrid.
//
// The automatic tolerance is 1 % of the diagonal of the box of all curves (which made one tree of
// the 27 unsnapped strokes of a drawn river), but at most a quarter of the curves' median length,
// so that drawings of many short strokes do not melt.
//
// Cost: that of a SegmentGrid and a query for each end.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/geometry/polyline.h"
#include "libstyle/geometry/segment_grid.h"

namespace libstyle {

enum class JunctionRole { kStart, kEnd, kInterior };

// A curve's part in a junction. For a start or end, the place is that end.
struct JunctionMember {
  CurvePlace at;
  JunctionRole role = JunctionRole::kStart;

  friend bool operator==(const JunctionMember&, const JunctionMember&) = default;
};

struct Junction {
  Point position;  // on the interior nearest to an end, or the mean of the ends
  std::vector<JunctionMember> members;  // 2 or more, ordered by curve, then along it

  friend bool operator==(const Junction&, const Junction&) = default;
};

struct JunctionGraph {
  double tolerance = 0;             // the one used
  std::vector<Junction> junctions;  // ordered by their first members
  // For each curve, its junctions in order along it; one that it takes part in twice stands twice.
  std::vector<std::vector<std::size_t>> junctions_of_curve;
};

// `tolerance` in the curves' units, >= 0; unset: automatic. Closed polylines have no ends; those
// without length take no part. Throws Error when the tolerance or a point is not finite.
JunctionGraph find_junctions(std::span<const Polyline> curves,
                             std::optional<double> tolerance = std::nullopt);

}  // namespace libstyle
