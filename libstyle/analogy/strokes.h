// SPDX-License-Identifier: Apache-2.0
// Styles that draw one line as several strokes: over and over, or broken.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/analogy/lane.h"
#include "libstyle/geometry/polyline.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {

// For each stroke the line it lies along: the nearest in the mean over its length. Neither has
// empty curves.
std::vector<std::size_t> lines_of_strokes(std::span<const Polyline> lines,
                                          std::span<const Polyline> strokes);

// The stroke in the direction of the line, with t the length along the line, rising: from the place
// nearest to its beginning to the one nearest to its end. A stroke across the line has a short
// stretch of it all the same. Both have a length.
SampledCurve laid_along(SampledCurve stroke, const Polyline& line);

// Puts strokes into the fewest lanes, so that those of one lane do not overlap: by their
// beginnings, each into the first lane that is free. For each stroke its lane. Interval colouring.
std::vector<std::size_t> assign_lanes(std::span<const Lane::Stroke> strokes);

}  // namespace libstyle
