// SPDX-License-Identifier: Apache-2.0
// Draws a walk over the example along a line.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/analogy/chain.h"
#include "libstyle/analogy/example.h"
#include "libstyle/analogy/runs.h"
#include "libstyle/analogy/style_grid.h"
#include "libstyle/analogy/sweep.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

struct DrawnLine {
  Polyline curve;
  std::vector<double> lengths;                // along the plain line, for each point; never falling
  std::vector<std::vector<double>> features;  // for each feature of the example and each point
  std::vector<std::size_t> pinned{};          // points that are held, rising
};

// A place of a line that it passes exactly.
struct HeldPlace {
  double x = 0;                   // style coordinate
  std::optional<Point> position;  // unset: where the plain line is
};

// Stages:
//  1. Each run is copied: its offsets go from the frames of the example into those of the line, at
//     the local scale.
//  2. Half a feature size to each side of a jump the two runs fade into each other.
//  3. What the fade bends is put right over three feature sizes to each side (stitch.h): the shapes
//     of the runs count, not the places.
//  4. Corners that the style rounds are rounded (rounded_corners.h).
//  5. At the places `held`, rising, the line is moved (warp.h) to where it was, or is wanted, and
//     passes there exactly: the ends of open lines, where other lines meet it, and constraints.
//  6. The features of the example are copied with the runs and fade as they do; lengths among them
//     at the local scale.
DrawnLine draw_walk(const Example& example, const Sweep& line, const StyleGrid& grid,
                    std::span<const ChainState> walk, std::span<const HeldPlace> held);

// For examples of several strokes: every lane with the pen down where it is down in the example. A
// stroke fades into that of the next run if both are there at the jump, and begins or ends there
// otherwise. Where the line is held, the stroke that is nearest passes exactly.
std::vector<DrawnLine> draw_strokes(const Example& example, const Sweep& line,
                                    const StyleGrid& grid, std::span<const ChainState> walk,
                                    std::span<const HeldPlace> held);

}  // namespace libstyle
