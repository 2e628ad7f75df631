// SPDX-License-Identifier: Apache-2.0
// A uniform grid over the segments of many polylines: which cross, and which is nearest.
//
//   const SegmentGrid grid(polylines);
//   for (const Crossing& crossing : grid.crossings()) ...
//
// What a crossing is: a place where one strand passes from one side of another. Exact contacts (a
// vertex on another strand, strands that share a stretch) are decided as if the strand with the
// higher index (polyline, then segment) were shifted by an infinitely small vector (e, e^2), e > 0:
//  - passing through another strand at a vertex, of one or of both, is one crossing, found once;
//  - touching without passing is none or two;
//  - strands that run on top of each other and part on opposite sides cross once, on the same side
//    none or two times.
// Two ends that meet, or an end that lies on another strand, thus cross or not as it happens; those
// who want neither ask for `proper`. Neighbouring segments of a strand never cross each other.
// The decision is exact (see orientation.h); the position is rounded.
//
// Cost: O(segments + cells passed) to build. Cells are squares with the mean segment's length or,
// for very short segments, such that there are about as many cells as segments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/geometry/box.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

// A place on one of several polylines.
struct CurvePlace {
  std::size_t curve = 0;
  PolylinePlace place;

  friend bool operator==(const CurvePlace&, const CurvePlace&) = default;
};

struct Crossing {
  CurvePlace first, second;  // first has the lower curve, then the lower segment
  Point position;
  bool proper = false;  // inside both segments: no vertex lies on the other strand

  friend bool operator==(const Crossing&, const Crossing&) = default;
};

struct NearestPlace {
  CurvePlace at;
  Point position;
  double distance = 0;

  friend bool operator==(const NearestPlace&, const NearestPlace&) = default;
};

class SegmentGrid {
 public:
  // Copies what it needs. Points must be finite; polylines without a segment take no part, except
  // that a single point can be nearest. `cell_size` 0: chosen as told above.
  explicit SegmentGrid(std::span<const Polyline> polylines, double cell_size = 0);

  // All crossings, self-crossings too, each once, ordered by first curve, first segment, second
  // curve, second segment.
  std::vector<Crossing> crossings() const;

  // The crossings of another polyline (which counts as the highest index) with the grid's: `first`
  // is on the grid, `second` on `other` with curve = number of polylines. Same order.
  std::vector<Crossing> crossings_with(const Polyline& other) const;

  // The nearest place, ties by the lower curve and segment; nothing when the grid is empty or all
  // is farther than `limit`.
  std::optional<NearestPlace> nearest(Point point, double limit) const;
  std::optional<NearestPlace> nearest(Point point) const;

  // For every segment that comes within `radius` of a point its nearest place, ordered by curve and
  // segment.
  std::vector<NearestPlace> within(Point point, double radius) const;

  std::size_t size() const { return segments_.size(); }  // in segments

 private:
  struct Segment {
    Point start, end;
    std::uint32_t curve, index;
  };

  std::vector<Segment> segments_;              // by curve, then index
  std::vector<std::uint32_t> segment_counts_;  // of each curve
  std::vector<bool> closed_;                   // whether each curve is
  Point origin_;                               // of the grid
  double cell_size_ = 1;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> cell_starts_;  // cell c holds members_[cell_starts_[c]] up to the
  std::vector<std::uint32_t> members_;      // next cell's: segments, rising
};

}  // namespace libstyle
