// SPDX-License-Identifier: Apache-2.0
// The map of sources as a picture: where each pixel of a result was copied from.
//
// A pixel holds the column in red, the row in green and the number of the example in blue, all
// counted from 0, as integers of 16 bits: a PNG or TIFF of three channels that any program reads.
#pragma once

#include <string>
#include <vector>

#include "libstyle/image/image_analogy.h"

namespace libstyle {

struct SourceMap {
  int width = 0;
  int height = 0;
  std::vector<SourcePixel> pixels;
};

// The bytes of a PNG. Throws Error where a number is above 65535.
std::string encode_source_map(const SourceMap& map);

// Throws Error when the file is no such picture.
SourceMap read_source_map(const std::string& name);

}  // namespace libstyle
