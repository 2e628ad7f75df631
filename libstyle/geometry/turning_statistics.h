// SPDX-License-Identifier: Apache-2.0
// How differently two curves bend: a number that tells styles of line apart without looking.
//
// Both curves are resampled to one spacing. At each scale k (a number of steps) the turning angle
// at a vertex is the angle between the chord that arrives from k vertices before and the chord that
// leaves to k vertices after. Position, direction and order are forgotten: what is left is the
// distribution of turning angles, and two curves differ by the Wasserstein-1 distance of theirs, in
// radians: the mean difference of equal quantiles, averaged over the scales.
//
// As measured on maps: one half of a coastline against the other .07 - .10, coast against another
// coast .08 - .12, coast against river .24 - .30. It rewards verbatim copying: read it together
// with the lengths of copied runs, and look at the picture.
//
// Cost: O(n log n) for n samples.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/geometry/polyline.h"

namespace libstyle {

// The turning angles of a curve that is sampled evenly already, at a scale of `step` vertices, in
// the order of the vertices. Open curves have none for the first and last `step` vertices.
std::vector<double> turning_angles(const Polyline& evenly_sampled, std::size_t step);

// The Wasserstein-1 distance of two samples of numbers, exactly; sizes may differ. Both hold at
// least one value.
double wasserstein_distance(std::vector<double> a, std::vector<double> b);

inline constexpr std::size_t kTurningScales[] = {1, 2, 4, 8, 16};

// The mean over the scales of the distance of the turning angles of two sets of curves, resampled
// to `spacing`. Throws Error if one of them is too short to have a turning angle at some scale.
double turning_distance(std::span<const Polyline> a, std::span<const Polyline> b, double spacing,
                        std::span<const std::size_t> scales = kTurningScales);
double turning_distance(const Polyline& a, const Polyline& b, double spacing,
                        std::span<const std::size_t> scales = kTurningScales);

}  // namespace libstyle
