// SPDX-License-Identifier: Apache-2.0
// From pictures to features and back: what neighbourhoods are compared by, and what is copied.
#pragma once

#include <vector>

#include "libstyle/image/image.h"
#include "libstyle/image/image_analogy.h"
#include "libstyle/image/level.h"

namespace libstyle::image {

// The features of the finest level, but for the responses of oriented filters: those are computed
// at each level, where they see larger and larger edges.
struct Features {
  std::vector<Image> guides;         // of A: colours or luminance, then the further guides
  std::vector<Image> filtered;       // of A'
  Image target_guide;                // of B
  int base_channels = 0;             // of A and B without the further guides
  std::vector<double> guide_shares;  // the weight of each guide channel, responses included
};

// Throws Error when pictures are missing, not finite, or do not fit each other.
void check_pictures(const ImageAnalogyInput& input);

Features make_features(const ImageAnalogyInput& input, const ImageAnalogyParameters& parameters);

// The levels, the finest first.
std::vector<LevelImages> feature_pyramid(const Features& features,
                                         const ImageAnalogyParameters& parameters);

// B' at full depth.
Image filtered_picture(const ImageAnalogyInput& input, const ImageAnalogyParameters& parameters,
                       const Features& features, const std::vector<SourcePixel>& sources);

}  // namespace libstyle::image
