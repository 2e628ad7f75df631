// SPDX-License-Identifier: Apache-2.0
// Where a shaky curve is and where it heads, near one of its samples.
//
// A cubic polynomial of arc length is fitted by least squares to a window round the sample. The
// window starts at `least_reach` and doubles as long as the curve stays a cubic within an eighth of
// the tolerance or, where the curve is noisier than that, within its noise: on calm stretches the
// direction comes from far round and is exact, in tight bends from nearby.
//
// Cost: O(samples in the window), at most kMaxLocalSamples.
#pragma once

#include <cstddef>
#include <span>

#include "libstyle/geometry/point.h"

namespace libstyle {

// A point of a curve, at an arc length that rises from sample to sample.
struct ArcSample {
  Point position;
  double length = 0;
  double weight = 0;       // the length it stands for
  std::size_t vertex = 0;  // of the polyline; kNoVertex: put in between
};

inline constexpr std::size_t kNoVertex = static_cast<std::size_t>(-1);
inline constexpr std::size_t kMaxLocalSamples = 512;

struct LocalFit {
  Point position;
  Vector tangent;  // unit
};

struct LocalFitParams {
  double least_reach = 1;  // arc length on either side, > 0
  double tolerance = 0.5;  // > 0
};

// The polynomial at sample `at`. The first and last of `samples` keep their position, and so do
// others whose fitted position is off by more than half the tolerance. At least two samples.
LocalFit fit_locally(std::span<const ArcSample> samples, std::size_t at,
                     const LocalFitParams& params);

}  // namespace libstyle
