// SPDX-License-Identifier: Apache-2.0
// Draws a curve B again in the style of an example: A is to A' as B is to B'.
//
// Source: Hertzmann, Oliver, Curless and Seitz, "Curve Analogies", Eurographics Workshop on
// Rendering 2002: the problem (sections 1 and 3.3), rigid invariance of what is compared (3.1),
// constraints at the ends (3.2), w_B (3.6). The method is another one.
//
// Stages:
//  1. The feature size F comes from the example.                               feature_size.h
//  2. A' is written as offsets from A in the frame of A's sweep, and cut into
//     pieces of equal length along A: the states.                              example.h
//  3. Jumps between states cost what they show.                                jump_costs.h
//  4. B is cut at its corners into lines, and each line into steps of the
//     size of a state, smaller where there is no room.                         style_grid.h
//  5. A walk over the states assigns a piece of the example to every step: a
//     random one (w_B = 0), or the one that suits B best (w_B > 0).            chain.h
//  6. The pieces are copied along B and stitched.                              assembly.h
//
// Symbols: A unfiltered, A' filtered, B line, B' drawn line, w_B shape_weight.
//
// Constraints (section 3.2). A hard one has the line bend towards it by what is beyond the style's
// own reach (bent_line.h), the walk pass near it, and the drawn line moved through it (assembly.h).
// A soft one becomes a hard one at the place that it and the line, drawn without it, agree on
// (soft_constraints.h).
//
// Departures. The paper searches for each sample of B' the best match among the samples of A',
// coarse to fine. Done literally, fine detail does not come back and corners knot; a chain over
// positions of A' assigns the whole curve at once, which the greedy search only approximates, and
// its pieces are copied as they were drawn. Positions are copied relative to A, as in "copying
// displacements", which the paper compares itself with; the jumps remove the repetition it finds
// fault with, and frames from blurred curves the distortion.
//
// Beyond the paper, which names them as open (section 5): features of A', such as its width, are
// copied with its pieces, in the size of the style (line_features.h). A' may be several strokes
// along A, or broken ones (strokes.h, lane.h). A walk can be changed bit by bit from frame to frame
// (living_walk.h).
//
// Guarantees: the same seed gives the same result, on any number of threads; moving or turning A,
// A' and B together does the same to B' (turning: under Invariance::kRotate); A' = A gives back B;
// open lines keep their end points exactly, outlines their corners; hard constraints are met
// exactly, soft ones the nearer the heavier they are. Cost: preparing O(n^2) in the
// states (at most 2048), drawing O(length of B / F) times O(states).
//
//   const CurveAnalogy style(pairs, parameters);
//   for (std::size_t i = 0; i < curves.size(); ++i) drawn[i] = style.draw(curves[i], {i});
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "libstyle/analogy/assembly.h"
#include "libstyle/analogy/curve_constraint.h"
#include "libstyle/analogy/example.h"
#include "libstyle/analogy/parameters.h"
#include "libstyle/analogy/style_summary.h"
#include "libstyle/geometry/polyline.h"

namespace libstyle {

// The walks of the lines of a curve, from corner to corner; empty where nothing was drawn or
// nothing was at random.
using LineWalks = std::vector<std::vector<ChainState>>;

struct StyledCurve {
  // Where the style draws a line as several strokes, `strokes` has them, in the order of the lines,
  // and this is B itself.
  Polyline curve;
  std::vector<double> lengths;       // along B, for each point; never falling
  std::vector<std::size_t> corners;  // points that are corners of B
  // Points that lie exactly where they are held, or where constraints want them, rising, but for
  // corners and ends, which do as well.
  std::vector<std::size_t> pinned;
  std::vector<std::vector<double>> features;  // for each feature of the example and each point
  std::vector<DrawnLine> strokes;
  std::vector<ChainRun> runs;  // of all lines one after the other
  LineWalks walks;
  // The mean of the local scale over the length of B: 1 where the style has its own size
  // everywhere.
  double mean_scale = 1;
  bool too_long = false;  // longer than longest_curve(): the curve is B itself
};

// What is asked of one curve besides its shape.
struct CurveTask {
  // Tells the curves of a drawing apart: equal curves with equal places come out alike.
  std::uint64_t place = 0;
  // Lengths along the curve, rising, at which it passes through its own place exactly, as it does
  // at its ends, so that lines that meet it there still do. Not if keep_ends is false.
  std::span<const double> held = {};
  // Added to the seed.
  std::uint64_t variant = 0;
  // Places that the curve passes exactly or is drawn towards, whatever keep_ends says. On a place
  // that is held, and on ends and corners, they come first. Of several strokes the nearest passes.
  std::span<const CurveConstraint> constraints = {};
  // The walks of the frame before, if the curve is to change from that one instead of being drawn
  // independently, and how much of them stays on average: 1 all, 0 nothing. Not where the walk is
  // not at random. The first frame is variant 0; what soft constraints come to there stays.
  const LineWalks* before = nullptr;
  double coherence = 0;
};

class CurveAnalogy {
 public:
  // Throws Error when a parameter is out of range or an example cannot serve.
  CurveAnalogy(std::span<const ExamplePair> pairs, const CurveAnalogyParameters& parameters);
  ~CurveAnalogy();
  CurveAnalogy(CurveAnalogy&&) noexcept;
  CurveAnalogy& operator=(CurveAnalogy&&) noexcept;

  // Draws one curve. Curves without length, too small for the style at its smallest, or longer than
  // longest_curve() come back as they are; those too small for the style are bent to constraints.
  // Throws Error when a constraint is out of range or as far away as a curve may be long, or when
  // hard ones contradict each other. Safe to call from several threads.
  StyledCurve draw(const Polyline& curve, const CurveTask& task) const;

  // A million steps of the example, or 65,536 spacings of the search: more would take hours, and
  // hardly be what was meant.
  double longest_curve() const;

  const Example& example() const;
  StyleSummary summary() const;

 private:
  class Implementation;
  std::unique_ptr<const Implementation> implementation_;
};

// For a single curve.
StyledCurve draw_by_analogy(const ExamplePair& pair, const Polyline& curve,
                            const CurveAnalogyParameters& parameters = {});

}  // namespace libstyle
