// SPDX-License-Identifier: Apache-2.0
// Neighbourhoods of pixels and the distance between two of them: F(p), F(q) and the weighted norm
// of section 3.2 of the paper.
//
// A neighbourhood has four parts: the window in the guide (A or B) and in what is filtered (A' or
// B') at this level, and the same two at the coarser one. With d the offset of a pixel in a window
// of radius r and c a channel, the squared difference of two samples weighs
//   w(d, c) = g(d) / (sum of g over the part) * share(c),  g(d) = exp(-|d|^2 / (2 sigma^2)),
//   sigma = (2 r + 1) / 4,
// so that pixels further away weigh less, and each part weighs the same at both scales however
// many pixels it has (the paper: "we also normalize the vectors so that each scale of the pyramid
// has equal weight"). share(c) is 1 / channels for what is filtered; the shares of the guides come
// from the caller: they hold the paper's w and the weights of further guides. The distance of two
// neighbourhoods is then a mean squared difference of samples, over four parts.
//
// At this level the filtered part holds only what has been made before in scan-line order; on a
// second pass, all of it but the pixel itself.
//
// Near the edge of the target only what is inside counts. Beyond the edge of an example its
// outermost pixels are repeated.
#pragma once

#include <cstddef>
#include <vector>

#include "libstyle/image/feature_plane.h"
#include "libstyle/image/level.h"

namespace libstyle::image {

// The weights of one window: rows of whole lanes, 0 where a sample does not count.
struct WindowWeights {
  int radius = 0;
  int row_lanes = 0;           // floats in a row of weights
  std::vector<float> weights;  // (2 radius + 1) * row_lanes
};

enum class FilteredPart : std::uint8_t {
  kBefore,  // the pixels before the middle in scan-line order
  kAround,  // all but the middle
  kWhole    // all: the coarser level
};

struct WindowSettings {
  int radius = 2;
  bool guide_in_middle_only = false;  // texture transfer: 1x1 neighbourhoods in A and B
  std::vector<double> guide_shares;   // one a guide channel
  int filtered_channels = 0;
  FilteredPart filtered = FilteredPart::kBefore;
};

WindowWeights make_window(const WindowSettings& settings);

// The same without what lies more than so many pixels to a side of the middle.
WindowWeights clipped(const WindowWeights& window, int channels, int left, int top, int right,
                      int bottom);

// The window without what lies outside of the target, round pixel (x, y) of it.
WindowWeights clipped_to(const FeaturePlane& target, const WindowWeights& window, int x, int y);
bool reaches_over(const FeaturePlane& target, const WindowWeights& window, int x, int y);

// Sum of weight times squared difference over two windows, given by their first samples and the
// floats from one row to the next.
float window_distance(const WindowWeights& window, const float* a, std::ptrdiff_t a_row,
                      const float* b, std::ptrdiff_t b_row);

}  // namespace libstyle::image
