// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/sampled_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"

namespace libstyle {
namespace {

// A vertex that the resampled curve must have.
struct Anchor {
  double t;
  PolylinePlace place;
  double length;  // from the first point
};

// The value at the end of a segment; `turn` is what one time round a closed curve adds.
double value_at_end(const std::vector<double>& values, std::size_t segment, double turn) {
  return segment + 1 < values.size() ? values[segment + 1] : values.front() + turn;
}

double value_at(const std::vector<double>& values, PolylinePlace place, double turn) {
  const double start = values[place.segment];
  if (place.fraction == 0) return start;
  const double end = value_at_end(values, place.segment, turn);
  return place.fraction == 1 ? end : start + place.fraction * (end - start);
}

PolylinePlace first_place() { return {0, 0}; }

PolylinePlace last_place(const Polyline& polyline) {
  const std::size_t segments = segment_count(polyline);
  return segments == 0 ? PolylinePlace{} : PolylinePlace{segments - 1, 1};
}

double last_parameter(const SampledCurve& curve) {
  return curve.polyline.closed ? curve.t.front() + 1 : curve.t.back();
}

// A parameter in the curve's range that means the same.
double normalized_parameter(const SampledCurve& curve, double t) {
  const double first = curve.t.front(), last = last_parameter(curve);
  if (!curve.polyline.closed) return std::clamp(t, first, last);
  if (t >= first && t < last) return t;
  const double turned = first + (t - first) - std::floor(t - first);
  return turned < last ? turned : first;
}

// First point, kept parameters and end, rising.
std::vector<Anchor> find_anchors(const SampledCurve& curve, const ArcLength& along,
                                 std::span<const double> kept) {
  std::vector<double> parameters(kept.begin(), kept.end());
  for (double& t : parameters) t = normalized_parameter(curve, t);
  std::ranges::sort(parameters);
  const double first = curve.t.front(), last = last_parameter(curve);
  std::vector<Anchor> anchors = {{first, first_place(), 0}};
  for (const double t : parameters) {
    if (t == anchors.back().t || t == last) continue;
    const PolylinePlace place = place_at_parameter(curve, t);
    anchors.push_back({t, place, along.length_to(place)});
  }
  anchors.push_back({last, last_place(curve.polyline), along.total()});
  return anchors;
}

std::size_t steps_between(const Anchor& from, const Anchor& to, double spacing, std::size_t least) {
  const double steps = std::round((to.length - from.length) / spacing);
  if (!(steps < static_cast<double>(kMaxSamples))) {
    throw Error("resampling would make more than " + std::to_string(kMaxSamples) +
                " points; choose a larger spacing");
  }
  return std::max(static_cast<std::size_t>(steps), least);
}

template <typename Value>
std::vector<Value> selected(const std::vector<Value>& values,
                            const std::vector<std::size_t>& indices) {
  std::vector<Value> result;
  result.reserve(indices.size());
  for (const std::size_t i : indices) result.push_back(values[i]);
  return result;
}

std::vector<std::size_t> indices_without_repeats(const Polyline& polyline, double tolerance) {
  const std::vector<Point>& points = polyline.points;
  std::vector<std::size_t> kept;
  if (points.empty()) return kept;
  const auto is_near = [&](std::size_t a, std::size_t b) {
    return distance(points[a], points[b]) <= tolerance;
  };
  kept.push_back(0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!is_near(kept.back(), i)) kept.push_back(i);
  }
  if (polyline.closed) {
    while (kept.size() > 1 && is_near(kept.back(), 0)) kept.pop_back();
  } else if (kept.size() > 1 && kept.back() != points.size() - 1) {
    const std::size_t last = points.size() - 1;
    while (kept.size() > 1 && is_near(kept.back(), last)) kept.pop_back();
    if (!is_near(kept.back(), last)) kept.push_back(last);
  }
  return kept;
}

}  // namespace

SampledCurve with_length_parameter(Polyline polyline) {
  std::vector<double> t = cumulative_lengths(polyline);
  const std::size_t count = polyline.points.size();
  const double total = t.empty() ? 0 : t.back();
  t.resize(count);
  const auto steps = static_cast<double>(std::max<std::size_t>(segment_count(polyline), 1));
  for (std::size_t i = 0; i < count; ++i) {
    t[i] = total > 0 ? t[i] / total : static_cast<double>(i) / steps;
  }
  return {std::move(polyline), std::move(t), {}};
}

PolylinePlace place_at_parameter(const SampledCurve& curve, double t) {
  assert(curve.t.size() == curve.size() && curve.size() > 0);
  if (segment_count(curve.polyline) == 0) return {};
  t = normalized_parameter(curve, t);
  // The last vertex below t begins the segment that first reaches t.
  const auto reached = std::lower_bound(curve.t.begin(), curve.t.end(), t);
  if (reached == curve.t.begin()) return first_place();
  const auto segment = static_cast<std::size_t>(reached - curve.t.begin()) - 1;
  const double start = curve.t[segment];
  const double end = value_at_end(curve.t, segment, 1);
  return {segment, std::min((t - start) / (end - start), 1.0)};
}

Point point_at_parameter(const SampledCurve& curve, double t) {
  return point_at(curve.polyline, place_at_parameter(curve, t));
}

SampledCurve sample_at(const SampledCurve& curve, std::span<const PolylinePlace> places) {
  SampledCurve result;
  result.polyline.closed = curve.polyline.closed;
  result.polyline.points.reserve(places.size());
  result.t.reserve(places.size());
  for (const PolylinePlace place : places) {
    const double t = value_at(curve.t, place, 1);
    result.polyline.points.push_back(point_at(curve.polyline, place));
    result.t.push_back(result.t.empty() ? t : std::max(t, result.t.back()));
  }
  for (const std::vector<double>& channel : curve.channels) {
    std::vector<double>& values = result.channels.emplace_back();
    values.reserve(places.size());
    for (const PolylinePlace place : places) values.push_back(value_at(channel, place, 0));
  }
  return result;
}

SampledCurve resample(const SampledCurve& curve, double spacing, std::span<const double> kept) {
  assert(spacing > 0 && curve.t.size() == curve.size());
  if (segment_count(curve.polyline) == 0) return curve;
  const ArcLength along(curve.polyline);
  const std::vector<Anchor> anchors = find_anchors(curve, along, kept);
  const std::size_t spans = anchors.size() - 1;
  const std::size_t least = curve.polyline.closed ? (2 + spans) / spans : 1;
  std::vector<PolylinePlace> places;
  std::vector<std::size_t> anchor_vertices;
  for (std::size_t i = 0; i < spans; ++i) {
    const Anchor& from = anchors[i];
    const Anchor& to = anchors[i + 1];
    const std::size_t steps = steps_between(from, to, spacing, least);
    anchor_vertices.push_back(places.size());
    places.push_back(from.place);
    for (std::size_t step = 1; step < steps; ++step) {
      const double share = static_cast<double>(step) / static_cast<double>(steps);
      places.push_back(along.place_at(from.length + share * (to.length - from.length)));
    }
  }
  if (!curve.polyline.closed) {
    anchor_vertices.push_back(places.size());
    places.push_back(anchors.back().place);
  }
  SampledCurve result = sample_at(curve, places);
  for (std::size_t i = 0; i < anchor_vertices.size(); ++i) {
    result.t[anchor_vertices[i]] = anchors[i].t;
  }
  return result;
}

SampledCurve resample_to_count(const SampledCurve& curve, std::size_t count) {
  assert(curve.t.size() == curve.size());
  if (segment_count(curve.polyline) == 0) return curve;
  const bool closed = curve.polyline.closed;
  assert(count >= (closed ? 3u : 2u));
  const ArcLength along(curve.polyline);
  const std::size_t steps = closed ? count : count - 1;
  std::vector<PolylinePlace> places = {first_place()};
  places.reserve(count);
  for (std::size_t step = 1; step < steps; ++step) {
    const double share = static_cast<double>(step) / static_cast<double>(steps);
    places.push_back(along.place_at(share * along.total()));
  }
  if (!closed) places.push_back(last_place(curve.polyline));
  return sample_at(curve, places);
}

Polyline resample(const Polyline& polyline, double spacing) {
  return resample(with_length_parameter(polyline), spacing).polyline;
}

Polyline resample_to_count(const Polyline& polyline, std::size_t count) {
  return resample_to_count(with_length_parameter(polyline), count).polyline;
}

SampledCurve without_repeated_points(const SampledCurve& curve, double tolerance) {
  const std::vector<std::size_t> kept = indices_without_repeats(curve.polyline, tolerance);
  SampledCurve result;
  result.polyline = {selected(curve.polyline.points, kept), curve.polyline.closed};
  result.t = selected(curve.t, kept);
  for (const std::vector<double>& channel : curve.channels) {
    result.channels.push_back(selected(channel, kept));
  }
  return result;
}

Polyline without_repeated_points(const Polyline& polyline, double tolerance) {
  const std::vector<std::size_t> kept = indices_without_repeats(polyline, tolerance);
  return {selected(polyline.points, kept), polyline.closed};
}

}  // namespace libstyle
