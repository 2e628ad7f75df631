// SPDX-License-Identifier: Apache-2.0
// Paths within the range that Cairo can count in.
//
// Cairo keeps coordinates in 24.8 fixed point: past 8,388,607 px they wrap round, and long before
// that dashes and joins far outside the picture cost time. Paths that stay near the window (within
// kMargin) go to Cairo as they are. Others are flattened and cut to the window first, which changes
// nothing that is seen, except:
// - points past 1e12 px are taken to lie at 1e12 px;
// - the phase of dashes counts curves outside the window by their chords.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "libstyle/geometry/path.h"

namespace libstyle {

constexpr double kMargin = 16384;       // px around the window that Cairo may see
constexpr double kMostReach = 1 << 16;  // px; a wider pen covers any window just as well

// The point, or the nearest one whose products stay finite: no coordinate past 1e12 px.
Point bounded(Point p);

// The part of a line within the window as a range of its parameter, if there is one.
std::optional<std::pair<double, double>> visible_range(Point from, Point to, const Box& window);

// Whether Cairo can take a path with this box in the device as it is.
bool is_near(const Box& box, const Box& window);

// A path with the same inside within the window, for both fill rules. `path` is on the device.
Path cut_fill(const Path& path, const Box& window);

// A run of a path, and how long the path was before it.
struct StrokeRun {
  Path path;
  double start_length = 0;
};

// The runs of a path that touch the window, which already allows for the reach of the pen. Lengths
// are measured by the pen.
std::vector<StrokeRun> cut_stroke(const Path& path, const Box& window,
                                  const Transform& pen_from_device);

}  // namespace libstyle
