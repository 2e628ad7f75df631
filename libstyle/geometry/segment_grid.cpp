// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/segment_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>

#include "libstyle/base/error.h"
#include "libstyle/geometry/orientation.h"

namespace libstyle {
namespace {

int sign(double value) { return (value > 0) - (value < 0); }

// The side of a line along `direction` to which the shift (e, e^2) leads: the sign of its cross
// product with the shift, where e^2 only counts for horizontal lines.
int side_of_shift(Vector direction) {
  return direction.y != 0 ? -sign(direction.y) : sign(direction.x);
}

std::size_t clamped_index(double place, std::size_t count) {
  if (!(place > 0)) return 0;
  return std::min(static_cast<std::size_t>(std::min(place, 1e15)), count - 1);
}

auto order(const Crossing& crossing) {
  return std::tuple(crossing.first.curve, crossing.first.place.segment, crossing.second.curve,
                    crossing.second.place.segment);
}

// A pair may meet in several cells.
void sort_and_drop_repeats(std::vector<Crossing>& crossings) {
  std::ranges::sort(crossings, {}, order);
  const auto same = [](const Crossing& a, const Crossing& b) { return order(a) == order(b); };
  crossings.erase(std::unique(crossings.begin(), crossings.end(), same), crossings.end());
}

}  // namespace

// --- The grid -----------------------------------------------------------------------------------

SegmentGrid::SegmentGrid(std::span<const Polyline> polylines) {
  for (std::size_t curve = 0; curve < polylines.size(); ++curve) {
    if (!std::ranges::all_of(polylines[curve].points, is_finite)) {
      throw Error("crossings: a point is not finite");
    }
    const std::size_t before = segments_.size();
    append_segments(polylines[curve], curve, segments_);
    closed_counts_.push_back(
        polylines[curve].closed ? static_cast<std::uint32_t>(segments_.size() - before) : 0);
  }
  assert(segments_.size() < std::numeric_limits<std::uint32_t>::max());
  choose_cells();
  fill_cells();
}

// Segments with a length or, where there is none, one point as a segment.
void SegmentGrid::append_segments(const Polyline& polyline, std::size_t curve,
                                  std::vector<Segment>& segments) {
  std::uint32_t ordinal = 0;
  for (std::size_t i = 0; i < segment_count(polyline); ++i) {
    const Point start = segment_start(polyline, i), end = segment_end(polyline, i);
    if (start == end) continue;
    segments.push_back(
        {start, end, static_cast<std::uint32_t>(curve), static_cast<std::uint32_t>(i), ordinal++});
  }
  if (ordinal == 0 && !polyline.points.empty()) {
    const Point point = polyline.points.front();
    segments.push_back({point, point, static_cast<std::uint32_t>(curve), 0, 0});
  }
}

// Squares of the mean segment's length, but not so small that there are more than a few a segment.
void SegmentGrid::choose_cells() {
  if (segments_.empty()) return;
  Box box;
  double length = 0;
  for (const Segment& segment : segments_) {
    box.include(segment.start);
    box.include(segment.end);
    length += distance(segment.start, segment.end);
  }
  const auto count = static_cast<double>(segments_.size());
  const double spread = std::max(box.width(), box.height());
  cell_size_ = std::max(
      {length / count, std::sqrt(box.width() / count) * std::sqrt(box.height()), spread / count});
  if (!(cell_size_ > 0) || !std::isfinite(cell_size_)) cell_size_ = std::max(spread, 1.0);
  origin_ = box.low;
  columns_ = static_cast<std::size_t>(box.width() / cell_size_) + 1;
  rows_ = static_cast<std::size_t>(box.height() / cell_size_) + 1;
  const double magnitude = std::max(
      {std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  margin_ = 1e-9 * cell_size_ + 1e-14 * magnitude;
}

void SegmentGrid::fill_cells() {
  std::vector<std::size_t> ends(columns_ * rows_ + 1, 0);
  for (const Segment& segment : segments_) {
    for_each_cell(
        segment, [&](std::size_t column, std::size_t row) { ++ends[row * columns_ + column + 1]; });
  }
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
  cell_starts_ = ends;
  cell_members_.resize(ends.back());
  for (std::uint32_t i = 0; i < segments_.size(); ++i) {
    for_each_cell(segments_[i], [&](std::size_t column, std::size_t row) {
      cell_members_[ends[row * columns_ + column]++] = i;
    });
  }
}

std::size_t SegmentGrid::column_of(double x) const {
  return clamped_index((x - origin_.x) / cell_size_, columns_);
}

std::size_t SegmentGrid::row_of(double y) const {
  return clamped_index((y - origin_.y) / cell_size_, rows_);
}

// Every cell the segment comes within the margin of, row by row.
template <typename Visit>
void SegmentGrid::for_each_cell(const Segment& segment, const Visit& visit) const {
  const bool downwards = segment.start.y <= segment.end.y;
  const Point low = downwards ? segment.start : segment.end;
  const Point high = downwards ? segment.end : segment.start;
  const std::size_t first_row = row_of(low.y - margin_), last_row = row_of(high.y + margin_);
  for (std::size_t row = first_row; row <= last_row; ++row) {
    // The x where the segment enters and leaves the row.
    const auto x_at = [&](double y) {
      if (y <= low.y) return low.x;
      if (y >= high.y) return high.x;
      return low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x);
    };
    const double top = origin_.y + static_cast<double>(row) * cell_size_;
    const double enter = row == first_row ? low.x : x_at(top - margin_);
    const double leave = row == last_row ? high.x : x_at(top + cell_size_ + margin_);
    const std::size_t first_column = column_of(std::min(enter, leave) - margin_);
    const std::size_t last_column = column_of(std::max(enter, leave) + margin_);
    for (std::size_t column = first_column; column <= last_column; ++column) visit(column, row);
  }
}

std::span<const std::uint32_t> SegmentGrid::members_of(std::size_t column, std::size_t row) const {
  const std::size_t cell = row * columns_ + column;
  return std::span(cell_members_)
      .subspan(cell_starts_[cell], cell_starts_[cell + 1] - cell_starts_[cell]);
}

// --- Crossings ----------------------------------------------------------------------------------

bool SegmentGrid::are_neighbours(const Segment& a, const Segment& b) const {
  if (a.curve != b.curve) return false;
  const std::uint32_t gap = b.ordinal > a.ordinal ? b.ordinal - a.ordinal : a.ordinal - b.ordinal;
  return gap <= 1 || gap + 1 == closed_counts_[a.curve];
}

// `b` is the later one, which is shifted.
std::optional<Crossing> SegmentGrid::crossing_of(const Segment& a, const Segment& b) {
  if (a.start == a.end || b.start == b.end) return std::nullopt;
  if (std::max(a.start.x, a.end.x) < std::min(b.start.x, b.end.x) ||
      std::max(b.start.x, b.end.x) < std::min(a.start.x, a.end.x) ||
      std::max(a.start.y, a.end.y) < std::min(b.start.y, b.end.y) ||
      std::max(b.start.y, b.end.y) < std::min(a.start.y, a.end.y)) {
    return std::nullopt;
  }
  const Vector along_a = a.end - a.start, along_b = b.end - b.start;
  const int b_start = orientation(a.start, a.end, b.start);
  const int b_end = orientation(a.start, a.end, b.end);
  const int shift_from_a = side_of_shift(along_a);
  if ((b_start != 0 ? b_start : shift_from_a) == (b_end != 0 ? b_end : shift_from_a)) {
    return std::nullopt;
  }
  const int a_start = orientation(b.start, b.end, a.start);
  const int a_end = orientation(b.start, b.end, a.end);
  const int shift_from_b = -side_of_shift(along_b);  // seen from b, it is a that moves back
  if ((a_start != 0 ? a_start : shift_from_b) == (a_end != 0 ? a_end : shift_from_b)) {
    return std::nullopt;
  }
  const double sine = cross(along_a, along_b);
  const auto fraction = [&](int at_start, int at_end, double across) {
    if (at_start == 0) return 0.0;
    if (at_end == 0) return 1.0;
    return sine != 0 ? std::clamp(across / sine, 0.0, 1.0) : 0.5;
  };
  const double on_a = fraction(a_start, a_end, cross(b.start - a.start, along_b));
  const double on_b = fraction(b_start, b_end, cross(b.start - a.start, along_a));
  const bool proper = a_start != 0 && a_end != 0 && b_start != 0 && b_end != 0;
  // A vertex that is met is met exactly.
  Point position = lerp(a.start, a.end, on_a);
  if (a_end == 0) position = a.end;
  if (b_start == 0) position = b.start;
  if (b_end == 0) position = b.end;
  return Crossing{{a.curve, {a.index, on_a}}, {b.curve, {b.index, on_b}}, position, proper};
}

std::vector<Crossing> SegmentGrid::crossings() const {
  std::vector<Crossing> result;
  for (std::size_t cell = 0; cell + 1 < cell_starts_.size(); ++cell) {
    for (std::size_t i = cell_starts_[cell]; i < cell_starts_[cell + 1]; ++i) {
      const Segment& a = segments_[cell_members_[i]];
      for (std::size_t j = i + 1; j < cell_starts_[cell + 1]; ++j) {
        const Segment& b = segments_[cell_members_[j]];
        if (are_neighbours(a, b)) continue;
        if (const auto crossing = crossing_of(a, b)) result.push_back(*crossing);
      }
    }
  }
  sort_and_drop_repeats(result);
  return result;
}

std::vector<Crossing> SegmentGrid::crossings_with(const Polyline& other) const {
  std::vector<Crossing> result;
  if (segments_.empty()) return result;
  std::vector<Segment> later;
  append_segments(other, closed_counts_.size(), later);
  for (const Segment& b : later) {
    for_each_cell(b, [&](std::size_t column, std::size_t row) {
      for (const std::uint32_t member : members_of(column, row)) {
        if (const auto crossing = crossing_of(segments_[member], b)) result.push_back(*crossing);
      }
    });
  }
  sort_and_drop_repeats(result);
  return result;
}

// --- Distances ----------------------------------------------------------------------------------

NearestPlace SegmentGrid::nearest_on(const Segment& segment, Point point) {
  const Vector along = segment.end - segment.start;
  const double squared = squared_norm(along);
  const double fraction =
      squared > 0 ? std::clamp(dot(point - segment.start, along) / squared, 0.0, 1.0) : 0;
  const Point position = fraction == 1 ? segment.end : lerp(segment.start, segment.end, fraction);
  return {{segment.curve, {segment.index, fraction}}, position, distance(point, position)};
}

std::optional<NearestPlace> SegmentGrid::nearest(Point point) const {
  return nearest(point, std::numeric_limits<double>::infinity());
}

std::optional<NearestPlace> SegmentGrid::nearest(Point point, double limit) const {
  if (segments_.empty()) return std::nullopt;
  std::optional<NearestPlace> best;
  std::uint32_t best_member = 0;
  const auto look_into = [&](std::size_t column, std::size_t row) {
    for (const std::uint32_t member : members_of(column, row)) {
      const NearestPlace place = nearest_on(segments_[member], point);
      if (!(place.distance <= limit)) continue;
      if (!best || place.distance < best->distance ||
          (place.distance == best->distance && member < best_member)) {
        best = place;
        best_member = member;
      }
    }
  };
  const std::size_t column = column_of(point.x), row = row_of(point.y);
  for (std::size_t ring = 0;; ++ring) {
    for_each_cell_of_ring(column, row, ring, look_into);
    const double outside = distance_beyond_ring(point, column, row, ring);
    if (std::isinf(outside) || outside - margin_ > (best ? best->distance : limit)) return best;
  }
}

// The square of cells that are `ring` steps from one, as far as there are cells.
template <typename Visit>
void SegmentGrid::for_each_cell_of_ring(std::size_t column, std::size_t row, std::size_t ring,
                                        const Visit& visit) const {
  const std::size_t first = column >= ring ? column - ring : 0;
  const std::size_t last = std::min(column + ring, columns_ - 1);
  const std::size_t top = row >= ring ? row - ring : 0;
  const std::size_t bottom = std::min(row + ring, rows_ - 1);
  for (std::size_t r = top; r <= bottom; ++r) {
    if (r + ring == row || r == row + ring) {
      for (std::size_t c = first; c <= last; ++c) visit(c, r);
      continue;
    }
    if (column >= ring) visit(column - ring, r);
    if (column + ring < columns_) visit(column + ring, r);
  }
}

// How far a point is at least from all cells more than `ring` steps away; infinite without any.
double SegmentGrid::distance_beyond_ring(Point point, std::size_t column, std::size_t row,
                                         std::size_t ring) const {
  const auto border = [&](double origin, std::size_t index) {
    return origin + static_cast<double>(index) * cell_size_;
  };
  double result = std::numeric_limits<double>::infinity();
  if (column > ring) result = std::min(result, point.x - border(origin_.x, column - ring));
  if (row > ring) result = std::min(result, point.y - border(origin_.y, row - ring));
  if (column + ring + 1 < columns_) {
    result = std::min(result, border(origin_.x, column + ring + 1) - point.x);
  }
  if (row + ring + 1 < rows_) {
    result = std::min(result, border(origin_.y, row + ring + 1) - point.y);
  }
  return result;
}

std::vector<NearestPlace> SegmentGrid::within(Point point, double radius) const {
  std::vector<NearestPlace> result;
  if (segments_.empty()) return result;
  std::vector<std::uint32_t> members;
  const double reach = radius + margin_;
  for (std::size_t row = row_of(point.y - reach); row <= row_of(point.y + reach); ++row) {
    for (std::size_t column = column_of(point.x - reach); column <= column_of(point.x + reach);
         ++column) {
      const auto more = members_of(column, row);
      members.insert(members.end(), more.begin(), more.end());
    }
  }
  std::ranges::sort(members);
  members.erase(std::unique(members.begin(), members.end()), members.end());
  for (const std::uint32_t member : members) {
    const NearestPlace place = nearest_on(segments_[member], point);
    if (place.distance <= radius) result.push_back(place);
  }
  return result;
}

}  // namespace libstyle
