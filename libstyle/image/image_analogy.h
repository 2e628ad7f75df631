// SPDX-License-Identifier: Apache-2.0
// Image analogies: a picture B is filtered as the picture A was to become A'.
//
// Source: Hertzmann, Jacobs, Oliver, Curless and Salesin, "Image analogies", SIGGRAPH 2001.
//
//   ImageAnalogyInput input;
//   input.examples = {{.unfiltered = photograph, .filtered = painting}};
//   input.target = another_photograph;
//   const ImageAnalogyResult result = make_image_analogy(input, {});
//
// What it does depends on the pictures: a photograph and its painting give a way of painting; a
// sharp picture as A' and a blurred one as A give detail to other blurred ones; regions painted in
// flat colours as A and the photograph that they stand for as A' give new landscapes ("texture by
// numbers"). Without A and B it is texture synthesis.
//
// Stages
//  1. Features. Colours, or luminance alone, remapped so that the examples' A has the mean and
//     deviation of B (luminance.h); responses of oriented filters for A and B, if they have a
//     weight; further guides.
//  2. Gaussian pyramids of all of them (resample.h), and from the coarsest level to the finest:
//  3. an index of the neighbourhoods of the examples (window.h, window_index.h),
//  4. a pass in scan-line order that gives each pixel of B' the best match (match_level.h).
//  5. The picture: each pixel is copied from A' at full depth, by the map of sources; by luminance,
//     the colour differences are those of B.
//
// Symbols: A, A', B, B' as above; s, the map of sources; kappa, the coherence; l, a level of 0 ..
// L, the finest; w, the guide weight.
//
// Departures
//  - The search is for an approximate nearest neighbour in a k-d tree over 15 principal components
//    and the length of what they leave, instead of the ANN library's tree over up to 99 % of the
//    variance, and stops where no match could be taken (window_index.h). `exact` holds all places
//    against each other.
//  - The place that the coarser level came from is always a candidate.
//  - Near the edges of B' only the part of a neighbourhood inside counts, as in the paper, but the
//    tree is searched there too, with the coarser level in place of what is outside, instead of
//    every place.
//  - Texture synthesis begins with random cells at the coarsest level, joined by passes with whole
//    neighbourhoods; the paper leaves its start open.
//
// Guarantees: the same bytes for the same input on any number of threads, wherever floats are IEEE;
// every pixel of B' in colour is a pixel of A'.
//
// Cost: time O(n_B log n_A) for n pixels; memory about 4 bytes a feature and pixel of the examples
// and the target, once, and 100 bytes a pixel of the examples for the index.
#pragma once

#include <cstdint>
#include <vector>

#include "libstyle/base/progress.h"
#include "libstyle/image/image.h"

namespace libstyle {

struct ImagePair {
  Image unfiltered;  // A; empty: texture synthesis
  Image filtered;    // A', of the same size
};

// Anything else that says what belongs where: labels, depths, normals.
struct ImageGuide {
  std::vector<Image> examples;  // one an example, as large as it
  Image target;                 // as large as B
  double weight = 1;            // against B, which has the guide weight; >= 0
};

struct ImageAnalogyInput {
  std::vector<ImagePair> examples;
  Image target;   // B; empty: texture synthesis
  int width = 0;  // of B' where there is neither B nor a guide
  int height = 0;
  std::vector<ImageGuide> guides;  // further ones
};

// What neighbourhoods are compared by.
enum class MatchFeatures : std::uint8_t {
  kColor,     // all colours of A, A', B and B'
  kLuminance  // luminance; B' gets its colours from B
};

struct ImageAnalogyParameters {
  // Tells results apart that are otherwise made the same way. Any number.
  std::uint64_t seed = 1;

  // kappa: how much worse than the best a match may be that carries on with a piece of the example,
  // as a share of its distance; 0 .. 1000. The paper: 2 to 25 for paintings, 1 for line art, 0.5 to
  // 5 for textures.
  double coherence = 5;

  MatchFeatures features = MatchFeatures::kColor;

  // By luminance: whether A and A' are first given the mean and deviation of B.
  bool remap_luminance = true;

  // The paper's w: how much A and B weigh against A' and B'; 0 .. 1000.
  double guide_weight = 1;

  // Whether of A and B only the pixel itself counts, at this level alone: for texture transfer.
  bool single_pixel_guide = false;

  // How much the oriented filter responses of A and B weigh; 0 .. 1000. 0: they are not computed.
  double orientation_weight = 0;

  // Sides of the neighbourhoods in pixels: odd, 3 .. 15 and 1 .. 15.
  int window = 5;
  int coarse_window = 3;

  // Levels of the pyramid, 1 .. 16; 0: as many as leave every side 16 pixels.
  int levels = 0;

  // Hold every place of the examples against every pixel: for comparison, for it is slow.
  bool exact = false;

  // Principal components of the search, 1 .. 15, and leaves of its tree that a query looks at,
  // 1 .. 10000. More of both come nearer to the exact search and take longer.
  int components = 15;
  int leaves = 24;

  // Threads; 0: one a core. Never changes the result.
  int threads = 0;
};

// Throws Error naming the first member that is out of range, and the range.
void validate(const ImageAnalogyParameters& parameters);

// Where a pixel of B' came from: a pixel of A'.
struct SourcePixel {
  int example = 0;
  int x = 0;
  int y = 0;

  friend bool operator==(const SourcePixel&, const SourcePixel&) = default;
};

struct LevelReport {
  int width = 0;
  int height = 0;
  double coherent_share = 0;  // of its pixels, that carry on with a neighbour's source
  double seconds = 0;
};

struct ImageAnalogyResult {
  Image filtered;                    // B'
  std::vector<SourcePixel> sources;  // one a pixel, rows from the top
  std::vector<LevelReport> levels;   // the coarsest first
};

// Throws Error when the pictures do not fit each other, or the parameters are out of range.
ImageAnalogyResult make_image_analogy(const ImageAnalogyInput& input,
                                      const ImageAnalogyParameters& parameters,
                                      const ProgressHandler& progress = {});

// The same sources applied to other pictures of the examples' sizes, such as normals or heights of
// A', one an example. All have as many channels. Throws Error when they do not fit.
Image copy_from_sources(const std::vector<Image>& examples, const std::vector<SourcePixel>& sources,
                        int width, int height);

}  // namespace libstyle
