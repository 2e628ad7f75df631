// SPDX-License-Identifier: Apache-2.0
// One level of the pyramid: the features of the examples, and of what is made from them.
//
// Guides (of A and B) come first among the channels of a pixel, then what is filtered (of A' and
// B'). Examples and target have the same channels, so that one window is held against another
// sample by sample. All examples lie in one plane, one below the other with a border between: a
// place in any of them is one number, and leaving one is stepping on a pixel that is no place.
#pragma once

#include <cstdint>
#include <vector>

#include "libstyle/image/feature_plane.h"
#include "libstyle/image/image.h"

namespace libstyle::image {

// Where each pixel of a target came from: indices in the plane of examples, rows from the top.
using SourceIndices = std::vector<PixelIndex>;

// The pictures of one level. A guide may have no channels: texture synthesis.
struct LevelImages {
  std::vector<Image> guides;    // of A, one an example
  std::vector<Image> filtered;  // A', as large
  Image target_guide;           // of B; of its size even without channels
};

struct ExampleFrame {
  int first_row = 0;  // in the plane
  int width = 0;
  int height = 0;
};

struct Level {
  // `border` is at least the radius of every window.
  Level(const LevelImages& images, int border);

  int guide_channels = 0;
  int filtered_channels = 0;
  std::vector<ExampleFrame> frames;
  FeaturePlane examples;
  std::vector<std::uint8_t> is_place;  // by PixelIndex: inside an example
  std::vector<PixelIndex> places;      // all of them, rising
  FeaturePlane target;                 // B' is 0 until something is put there

  // What B' has at a pixel, from the example pixel that it is copied from.
  void copy(PixelIndex source, PixelIndex to);

  // The example that a place lies in.
  int example_of(PixelIndex source) const;
  PixelIndex place(int example, int x, int y) const {
    return examples.index(x, frames[example].first_row + y);
  }
};

// For each pixel of `fine.examples` that is a place, its pixel in the coarser level; 0 elsewhere.
std::vector<PixelIndex> coarse_places(const Level& fine, const Level& coarse);

// What B' is before anything is known at this level: the coarser one, each pixel four times.
// Fills the border of the target as well.
void start_from_coarse(Level& fine, const Level& coarse);

}  // namespace libstyle::image
