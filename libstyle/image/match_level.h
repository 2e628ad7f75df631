// SPDX-License-Identifier: Apache-2.0
// One pass over one level in scan-line order: BESTMATCH of the paper (section 3.2) at each pixel.
//
// Two candidates are held against each other at a pixel q. The coherent one carries on with what a
// neighbour r was copied from, s(r) + (q - r), the best over all r of the window that have been
// made. The approximate one is the best of the places that the index finds, and of the one that the
// coarser level came from. The coherent one is taken when
//   d_coh <= d_app (1 + kappa_l),  kappa_l = kappa 2^(l - L);
// so it is looked for first, and the index only asked for places nearer than d_coh / (1 + kappa_l).
//
// Where nothing is known, and all places are alike, one is drawn at random.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "libstyle/image/level.h"
#include "libstyle/image/neighborhood.h"
#include "libstyle/image/window_index.h"

namespace libstyle::image {

// The level above, done, and how places lead there.
struct CoarserLevel {
  const Level* level = nullptr;
  const SourceIndices* sources = nullptr;
  std::vector<PixelIndex> places;  // coarse_places()
};

struct MatchSettings {
  double coherence = 0;  // kappa_l
  bool exact = false;    // hold every place against every pixel; needs no index
  std::uint64_t seed = 1;
  std::uint64_t pass = 0;  // a number of its own for each pass of a run
  int threads = 0;
};

struct MatchCounts {
  std::size_t pixels = 0;
  std::size_t coherent = 0;  // that carry on with a neighbour's source
};

// `neighborhood` says what counts, and so whether this is the first pass, which knows only what
// comes before a pixel, or a later one over `sources` and a target that are there already.
struct MatchPass {
  const Neighborhood& neighborhood;
  bool is_first = true;
  const CoarserLevel& coarser;
  const WindowIndex* index = nullptr;  // null: exact
  // Called after each piece of a row with its number of pixels; from any thread, one at a time.
  std::function<void(std::size_t)> progress = {};
};

// Fills `sources` and the filtered channels of the target.
MatchCounts match_level(Level& level, const MatchPass& pass, const MatchSettings& settings,
                        SourceIndices& sources);

// The windows of a place in the examples, and the steps between their rows.
Windows example_windows(const Level& level, const Neighborhood& neighborhood,
                        const CoarserLevel& coarser, PixelIndex place);
RowSteps example_rows(const Level& level, const CoarserLevel& coarser);

}  // namespace libstyle::image
