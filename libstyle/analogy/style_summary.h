// SPDX-License-Identifier: Apache-2.0
// What a style came out as: what was left to the example, and what that gave.
#pragma once

#include <cstddef>
#include <optional>

#include "libstyle/analogy/example.h"
#include "libstyle/analogy/jump_model.h"
#include "libstyle/analogy/parameters.h"

namespace libstyle {

// Lengths are in px of the drawing, so the scale is in them.
struct StyleSummary {
  CurveAnalogyParameters parameters;  // as the style was asked for

  // The example: pairs of curves, and their lengths, all taken together.
  std::size_t lines = 0;
  std::size_t strokes = 0;  // filtered curves: more than lines where these are several strokes
  double filtered_length = 0;
  double unfiltered_length = 0;

  // F, along the filtered and along the unfiltered curves (feature_size.h).
  double feature_size = 0;
  double feature_along = 0;
  // How far the style strays from its own mean offset: 95 % of it less than this.
  double reach = 0;
  double sample_spacing = 0;

  // The chain.
  std::size_t states = 0;
  double step = 0;              // of a state, along the unfiltered curves
  double tolerance = 0;         // tau, px^2: what a jump that still looks alike may cost
  double jumping_share = 0;     // of the states: those from which there is a jump
  double mean_run = 0;          // feature sizes along the unfiltered curves
  std::size_t longest_run = 0;  // states; 0: any number

  // The paper's search, if that draws.
  struct Search {
    SearchParameters parameters;
    double finest_spacing = 0;  // px of the drawing
    int levels = 0;
  };
  std::optional<Search> search;
};

// All but the search.
StyleSummary summarize(const Example& example, const JumpModel& jumps,
                       const CurveAnalogyParameters& parameters, double mean_run,
                       std::size_t longest_run);

// The filtered curves as the style has them: opened, sampled and at its scale.
std::vector<Polyline> filtered_curves(const Example& example);

}  // namespace libstyle
