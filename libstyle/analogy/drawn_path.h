// SPDX-License-Identifier: Apache-2.0
// One path of a drawing, drawn again.
#pragma once

#include <vector>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/analogy/drawing_constraints.h"
#include "libstyle/analogy/drawing_measures.h"
#include "libstyle/analogy/flat_paths.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// What is wanted of a path, and of how it was drawn in the frame before.
struct PathTask {
  CurveTask first;  // of the first subpath, but for the places that it passes
  const PathConstraints& constraints;
  std::vector<LineWalks>* walks = nullptr;  // one for each subpath; null if there are no frames
  bool is_measured = false;
};

struct PathMeasure {
  double length = 0;
  double small_length = 0;           // of curves with the style at less than half its size
  bool too_long = false;             // it, or one of its subpaths, stays as it is
  std::vector<CurveMeasure> curves;  // if they are wanted
};

// Replaces the path, its values along the curve and its shape. `flat` is of a path that is the same
// curve.
PathMeasure draw_path(PathRecord& record, const FlatPath& flat, const CurveAnalogy& style,
                      const PathTask& task);

}  // namespace libstyle
