// SPDX-License-Identifier: Apache-2.0
// Curves whose vertices carry values, and resampling that carries the values along.
//
// The parameter t ties corresponding places of several curves together (an example before and after
// styling, a curve and its blurred copy), so it goes with every vertex through every resampling.
// Between vertices, positions and values are interpolated linearly.
//
//   SampledCurve curve = with_length_parameter(polyline);
//   SampledCurve fine = resample(curve, 0.5, {{0.25}});  // a vertex at t = 0.25, exactly
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/geometry/polyline.h"

namespace libstyle {

// t and each channel hold one value for each point. t never falls. Going round a closed curve once
// adds 1 to t: its last segment leads from t.back() to t.front() + 1, so t.back() <= t.front() + 1.
struct SampledCurve {
  Polyline polyline;
  std::vector<double> t;
  std::vector<std::vector<double>> channels;

  std::size_t size() const { return polyline.points.size(); }
  friend bool operator==(const SampledCurve&, const SampledCurve&) = default;
};

// t is the fraction of the arc length: 0 at the first point and, on an open curve, 1 at the last.
// Where there is no length at all, t rises evenly with the index.
SampledCurve with_length_parameter(Polyline polyline);

// The place where the curve has parameter t; the first one where t stands still. Outside the
// curve's range: the nearer end of an open curve; closed curves go round.
PolylinePlace place_at_parameter(const SampledCurve& curve, double t);
Point point_at_parameter(const SampledCurve& curve, double t);

// The curve's vertices at the given places instead of its own, which must rise along the curve.
SampledCurve sample_at(const SampledCurve& curve, std::span<const PolylinePlace> places);

// New vertices, evenly spaced by arc length, as near to `spacing` (> 0) as the length allows; at
// least 2 on an open and 3 on a closed curve. Keeps exactly: the first point and, on open curves,
// the last; and a vertex with each of the parameters `kept` (any order, repeats allowed; outside
// the range: the nearer end), whose t is then that value bit for bit. Between two kept vertices the
// spacing is even; two kept values at the same place make one vertex.
// Throws Error if that would be more than kMaxSamples vertices.
SampledCurve resample(const SampledCurve& curve, double spacing, std::span<const double> kept = {});

// `count` vertices, evenly spaced by arc length: 2 or more on an open, 3 or more on a closed curve.
SampledCurve resample_to_count(const SampledCurve& curve, std::size_t count);

// The same without values.
Polyline resample(const Polyline& polyline, double spacing);
Polyline resample_to_count(const Polyline& polyline, std::size_t count);

inline constexpr std::size_t kMaxSamples = std::size_t{1} << 26;

// Removes points that are no farther than `tolerance` from the one kept before, so that every
// segment left is longer. The first point stays, and on open curves the last. A curve of one point
// stays one point.
SampledCurve without_repeated_points(const SampledCurve& curve, double tolerance = 0);
Polyline without_repeated_points(const Polyline& polyline, double tolerance = 0);

}  // namespace libstyle
