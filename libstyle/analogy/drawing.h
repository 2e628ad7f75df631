// SPDX-License-Identifier: Apache-2.0
// A whole drawing in the style of an example, or each of its parts in another.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/analogy/drawing_constraints.h"
#include "libstyle/analogy/drawing_measures.h"
#include "libstyle/base/progress.h"
#include "libstyle/base/warning.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// What one frame of a drawing hands to the next: the walks of every path and its subpaths.
using DrawnWalks = std::vector<std::vector<LineWalks>>;

struct DrawingOptions {
  int threads = 0;  // 0: one a core; does not change the result
  ProgressHandler progress;
  WarningHandler warn;
  std::uint64_t variant = 0;  // added to the seeds
  // Frames: the walks of the frame before, none for the first, which are changed to those of this
  // one. The document and the plan are the same as they were then.
  DrawnWalks* walks = nullptr;
  double coherence = 0;  // how much of the frame before stays, 0 .. 1
  // Where the measures of each style of the plan go, if they are wanted. Of styles that nothing is
  // drawn in they are left empty.
  std::vector<StyleMeasures>* measures = nullptr;
  // Besides the constraint records of the drawing, which always count.
  std::span<const AskedConstraint> constraints = {};
};

// What the parts of a drawing are drawn in.
struct StylePlan {
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  struct Style {
    const CurveAnalogy* analogy = nullptr;  // null if nothing is drawn in it
    std::string name = "the style";         // in warnings
    bool has_fitting_scale = false;         // rather than one that was given
  };

  std::vector<Style> styles;
  // For each record the place in `styles` of what its path is drawn in. kNone: it stays as it is.
  std::vector<std::size_t> style_of_record;
};

// Draws every subpath of every path record again; all else stays. The outcome is smooth paths of
// few cubics, with the corners of the drawing and of the style kept, within a hundredth of a
// feature size. Values along the curves are carried to the new vertices, but where the example has
// values of the same name along its lines: those take their place, or come besides. Paths that are
// the same curve, such as a filling and its outline, are drawn alike. Coordinates are rounded to
// 1/10000 px except where curves begin and end. Lines that met, at their ends or one with the
// middle of another, still meet.
//
// Lines of different styles meet as well, and lines that stay with lines that do not. Which styles
// other parts have does not change how a part is drawn.
//
// A style of several strokes makes each line a path of several subpaths. What is filled keeps its
// shape then, and its line becomes a record of its own, in front of it or behind as it was painted;
// what is filled and has no line stays as it is.
//
// Paths pass through their hard constraints exactly and near the soft ones (curve_analogy.h,
// drawing_constraints.h). Lines that met one at an end which a constraint moves stay where they
// are.
//
// Warns of curves that are too long for their style, of each style when most of its lines had to be
// drawn with it at less than half its size, and of `options.constraints` without effect. Throws
// Error when constraints contradict each other.
void draw_again(Document& document, const StylePlan& plan, const DrawingOptions& options);

// All of it in one style.
void draw_again(Document& document, const CurveAnalogy& style, const DrawingOptions& options);

}  // namespace libstyle
