// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/arc_length.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace libstyle {

std::vector<double> cumulative_lengths(const Polyline& polyline) {
  std::vector<double> result;
  if (polyline.points.empty()) return result;
  const std::size_t segments = segment_count(polyline);
  result.reserve(segments + 1);
  result.push_back(0);
  for (std::size_t i = 0; i < segments; ++i) {
    result.push_back(result.back() +
                     distance(segment_start(polyline, i), segment_end(polyline, i)));
  }
  return result;
}

double arc_length(const Polyline& polyline) {
  double sum = 0;
  for (std::size_t i = 0; i < segment_count(polyline); ++i) {
    sum += distance(segment_start(polyline, i), segment_end(polyline, i));
  }
  return sum;
}

ArcLength::ArcLength(Polyline polyline)
    : polyline_(std::move(polyline)), cumulative_(cumulative_lengths(polyline_)) {
  assert(!polyline_.points.empty());
}

double ArcLength::length_to(PolylinePlace place) const {
  const double start = cumulative_[place.segment];
  if (place.fraction == 0) return start;
  return start + place.fraction * (cumulative_[place.segment + 1] - start);
}

PolylinePlace ArcLength::place_at(double length) const {
  if (total() == 0) return {};
  if (polyline_.closed) {
    length = std::fmod(length, total());
    if (length < 0) length += total();
    if (length >= total()) length = 0;
  }
  if (!(length < total())) length = total();
  if (length < 0) length = 0;
  // The last vertex not beyond `length`, which begins a segment that has a length, except at the
  // very end, where the segment before it is meant.
  auto after = std::upper_bound(cumulative_.begin(), cumulative_.end(), length);
  if (after == cumulative_.end()) after = std::lower_bound(cumulative_.begin(), after, length);
  const auto segment = static_cast<std::size_t>(after - cumulative_.begin()) - 1;
  const double start = cumulative_[segment];
  return {segment, std::min((length - start) / (cumulative_[segment + 1] - start), 1.0)};
}

Vector ArcLength::tangent_at(double length) const {
  if (total() == 0) return {};
  const std::size_t segment = place_at(length).segment;
  return normalized(segment_end(polyline_, segment) - segment_start(polyline_, segment));
}

}  // namespace libstyle
