// SPDX-License-Identifier: Apache-2.0
// Everything about a curve analogy that can be set. The defaults are meant to be left alone:
// lengths come from the example itself.
#pragma once

#include <cstdint>
#include <optional>

#include "libstyle/analogy/greedy/search_parameters.h"

namespace libstyle {

// What a piece of the example may undergo on its way into the drawing.
enum class Invariance : std::uint8_t {
  kRotate,    // it is turned along with the line: the style is the same in every direction
  kTranslate  // it keeps its direction on the page: horizontal and vertical lines differ
};

// How a line is drawn.
enum class AnalogyMethod : std::uint8_t {
  kChain,  // all of it at once, as a walk over pieces of the example (chain.h)
  kGreedy  // vertex by vertex from coarse to fine, as in the paper (greedy/greedy_search.h)
};

struct CurveAnalogyParameters {
  // Tells results apart that are otherwise made the same way. Any number.
  std::uint64_t seed = 1;

  // What may happen to the example's pieces (see Invariance). Reflections never happen.
  Invariance invariance = Invariance::kRotate;

  // How much the shape of a line decides which piece of the example is put there; no unit, >= 0.
  // 0: the example is a texture, drawn anew at random along each line. 2 (the paper's w_B): where
  // the line looks like the unfiltered example, it is drawn as the example was drawn there; start
  // from 2 for letters and for corners with a character of their own.
  double shape_weight = 0;

  // The size of the example in the drawing: px of the drawing for a px of the example. > 0; 1 draws
  // the style as large as it was drawn by hand.
  double scale = 1;

  // Half the size of what makes the style, such as half a wavelength, in px of the example. > 0.
  // Unset: found from the example (feature_size.h).
  std::optional<double> feature_size;

  // Into how many samples the filtered example is cut, 100 .. 20000. Time grows between linearly
  // and quadratically, detail linearly.
  int samples = 1200;

  // The mean length copied from the example in one go, in feature sizes along the line; 2 .. 1000.
  // Short runs vary more, long ones are more faithful. Unset: 8 where lines are drawn again, 2
  // where a curve is made from nothing (synthesis.h).
  std::optional<double> mean_run;

  // How much of its own detail a line loses before it is drawn, in feature sizes along the line;
  // 0 .. 4. 0 keeps it, which suits clean lines; 1 replaces the tremble of scanned or shaky lines.
  double smoothing = 0;

  // Lines too short or too tight for the style at its size get the style smaller, down to this
  // factor, and lines that would need less stay as they are; 0 < smallest_scale <= 1. 1 draws it at
  // the same size everywhere.
  double smallest_scale = 0.1;

  // How sharply an open line, or a side of an outline, must turn to have a corner there, in
  // degrees; 0 < corner_angle <= 180. Corners stay in their places, and the style begins anew at
  // each. With shape_weight > 0 corners belong to the shape and are not treated apart.
  double corner_angle = 40;

  // Whether open lines keep their end points exactly, so that lines that met still meet.
  bool keep_ends = true;

  // The paper's own method is there for comparison; what is said above about runs does not concern
  // it.
  AnalogyMethod method = AnalogyMethod::kChain;

  // The symbols of the paper's method. Seed, rotation, shape weight and samples are taken from
  // above. paper_parameters() makes it faithful to the print.
  SearchParameters search;
};

// Throws Error naming the first member that is out of range, and the range.
void validate(const CurveAnalogyParameters& parameters);

}  // namespace libstyle
