// SPDX-License-Identifier: Apache-2.0
// How well a drawing came out: numbers for people who compare, and for programs that watch.
//
// Lengths are in px of the drawing. Likeness is the distance of turning angles
// (geometry/turning_statistics.h) with the example cut into 1,200 steps; it rewards verbatim
// copying, so it has to be read together with the runs and the coverage.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/analogy/example.h"
#include "libstyle/analogy/runs.h"
#include "libstyle/geometry/path.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

// One curve that was drawn.
struct CurveMeasure {
  double length = 0;      // of the plain curve
  double mean_scale = 1;  // of the style
  bool is_kept = false;   // it stays as it was
  std::size_t vertices_before = 0, vertices_after = 0;
  std::size_t held = 0;      // places where other lines end on it
  double end_distance = 0;   // of the ends from where they were
  double held_distance = 0;  // of held places from the curve that is written
  double fit_distance = 0;   // of what was drawn from the curve that is written
  std::vector<ChainRun> runs;
  std::vector<Polyline> drawn;  // the curve or its strokes, with the style at its own size
};

// Measures a curve without its style: what was drawn along `plain`, and the path that is written of
// it. `held` are lengths along `plain`.
CurveMeasure measure_curve(const Polyline& plain, std::span<const double> held,
                           const StyledCurve& drawn, const Path& written);

// The same for a curve that is drawn along nothing, and written anywhere on a page.
CurveMeasure measure_new_curve(const StyledCurve& drawn, const Path& written);

// The curves of one style in one drawing.
struct StyleMeasures {
  std::size_t curves = 0;
  std::size_t kept = 0;  // curves that stay as they were
  double length = 0;     // of the plain curves
  std::size_t vertices_before = 0, vertices_after = 0;

  // The largest distances, see CurveMeasure.
  std::size_t held = 0;
  double end_distance = 0, held_distance = 0, fit_distance = 0;

  // The pieces copied in one go, in px of the drawing along the unfiltered example and as shares of
  // it.
  std::size_t runs = 0;
  double median_run = 0, longest_run = 0;
  double median_run_share = 0, longest_run_share = 0;
  double coverage = 0;  // the share of the example that is seen somewhere

  // Radians; unset where a curve is too short to tell.
  std::optional<double> turning_distance;            // of what was drawn from the example
  std::optional<double> turning_distance_of_halves;  // of the example's halves from each other

  double mean_scale = 1;   // over the length of the plain curves
  double small_share = 0;  // of that length: with the style at less than half its size
};

StyleMeasures summarize(std::span<const CurveMeasure> curves, const Example& example);

}  // namespace libstyle
