// SPDX-License-Identifier: Apache-2.0
// The paths of a drawing as lines, with the places where other lines end on them.
#pragma once

#include <span>
#include <vector>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/geometry/flatten.h"
#include "libstyle/geometry/path.h"

namespace libstyle {

struct FlatPath {
  std::vector<FlattenedSubpath> subpaths;
  std::vector<std::vector<double>> held;  // for each subpath: lengths along it, rising
  bool too_long = false;                  // and therefore not flattened
};

// As finely as the style sees lines.
FlatPath flatten_path(const Path& path, const CurveAnalogy& style);

// Finds the lines that end on the middle of others, and notes on the latter where.
void find_meetings(std::span<FlatPath> paths);

}  // namespace libstyle
