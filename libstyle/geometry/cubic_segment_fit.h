// SPDX-License-Identifier: Apache-2.0
// One cubic Bezier segment for a stretch of a curve.
//
// Ends and end tangents are given, so that two handle lengths are left, found by least squares for
// samples at known parameters; then every sample's parameter is moved to the nearest place by a
// Newton step, and so on for a few rounds (Schneider, "An algorithm for automatically fitting
// digitized curves", Graphics Gems, 1990).
//
// A loop or a cusp takes a total turn of pi at least, and a Bezier curve turns no more than its
// control polygon. Segments whose control polygon turns by more than pi are refused; so there are
// neither.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "libstyle/geometry/bezier.h"
#include "libstyle/geometry/local_fit.h"

namespace libstyle {

struct SegmentFit {
  CubicBezier curve;
  double error = 0;  // no vertex among the samples is farther from the curve
};

class SegmentFitter {
 public:
  // The segment from `start` to `end` along `samples`, the first of which belongs to the start and
  // the last to the end. Nothing if no segment within `tolerance` of all samples was
  // found.
  std::optional<SegmentFit> fit(std::span<const ArcSample> samples, const LocalFit& start,
                                const LocalFit& end, double tolerance);

  // For samples of neighbouring vertices and what lies between, where there is no freedom left:
  // always a segment, no farther than about the tolerance from the chord.
  SegmentFit fit_neighbours(std::span<const ArcSample> samples, const LocalFit& start,
                            const LocalFit& end, double tolerance);

 private:
  // The largest, of all samples and of the vertices among them.
  struct Distances {
    double of_samples, of_vertices;
  };

  void set_parameters_by_length(std::span<const ArcSample> samples);
  CubicBezier with_best_handles(std::span<const ArcSample> samples, const LocalFit& start,
                                const LocalFit& end) const;
  Distances improve_parameters(std::span<const ArcSample> samples, const CubicBezier& curve);

  std::vector<double> parameters_;  // of the samples, kept between calls to save allocations
};

}  // namespace libstyle
