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
// Segments without length are passed over.
//
// Cost: O(n) to build for n segments of similar length, in at most about 4 n cells; crossings in
// O(n + pairs of segments that share a cell).
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
  // Copies what it needs. A polyline that is one point is only there to be nearest. Throws Error
  // when a point is not finite.
  explicit SegmentGrid(std::span<const Polyline> polylines);

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

 private:
  struct Segment {
    Point start, end;
    std::uint32_t curve = 0;
    std::uint32_t index = 0;    // in its polyline
    std::uint32_t ordinal = 0;  // among those of its polyline that have a length
  };

  static void append_segments(const Polyline& polyline, std::size_t curve,
                              std::vector<Segment>& segments);
  void choose_cells();
  void fill_cells();

  std::size_t column_of(double x) const;
  std::size_t row_of(double y) const;
  template <typename Visit>
  void for_each_cell(const Segment& segment, const Visit& visit) const;
  template <typename Visit>
  void for_each_cell_of_ring(std::size_t column, std::size_t row, std::size_t ring,
                             const Visit& visit) const;
  double distance_beyond_ring(Point point, std::size_t column, std::size_t row,
                              std::size_t ring) const;
  std::span<const std::uint32_t> members_of(std::size_t column, std::size_t row) const;

  bool are_neighbours(const Segment& a, const Segment& b) const;
  static std::optional<Crossing> crossing_of(const Segment& a, const Segment& b);
  static NearestPlace nearest_on(const Segment& segment, Point point);

  std::vector<Segment> segments_;             // by curve, then index
  std::vector<std::uint32_t> closed_counts_;  // segments of each curve; 0 for open ones
  Point origin_;                              // of the grid
  double cell_size_ = 1;
  double margin_ = 0;  // by which segments are taken to be wider, against rounding
  std::size_t columns_ = 0, rows_ = 0;
  // Cell c holds cell_members_ from cell_starts_[c] up to cell_starts_[c + 1]: segments, rising.
  std::vector<std::size_t> cell_starts_;
  std::vector<std::uint32_t> cell_members_;
};

}  // namespace libstyle
