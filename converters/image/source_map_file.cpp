// SPDX-License-Identifier: Apache-2.0
#include "converters/image/source_map_file.h"

#include <cmath>

#include "converters/common/files.h"
#include "converters/image/image_file.h"
#include "libstyle/base/error.h"

namespace libstyle {
namespace {

constexpr int kMost = 65535;

float to_sample(int number) {
  if (number > kMost) {
    throw Error("a map of sources holds places up to 65535, and an example is larger");
  }
  return static_cast<float>(static_cast<double>(number) / kMost);
}

int to_number(float sample) { return static_cast<int>(std::lround(double{sample} * kMost)); }

}  // namespace

std::string encode_source_map(const SourceMap& map) {
  Image image(map.width, map.height, 3);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const SourcePixel& source = map.pixels[std::size_t(y) * map.width + x];
      const auto pixel = image.pixel(x, y);
      pixel[0] = to_sample(source.x);
      pixel[1] = to_sample(source.y);
      pixel[2] = to_sample(source.example);
    }
  }
  return encode_image(image, ImageFormat::kPng, SampleDepth::k16);
}

SourceMap read_source_map(const std::string& name) {
  const ImageFile file = read_image(name);
  if (file.depth != SampleDepth::k16 || file.image.channels != 3) {
    throw Error({display_name(name)},
                "is no map of sources; that is a picture of three channels with 16 bits each, as "
                "--source-map writes it");
  }
  SourceMap map{file.image.width, file.image.height, {}};
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const auto pixel = file.image.pixel(x, y);
      map.pixels.push_back({to_number(pixel[2]), to_number(pixel[0]), to_number(pixel[1])});
    }
  }
  return map;
}

}  // namespace libstyle
