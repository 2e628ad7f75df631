// SPDX-License-Identifier: Apache-2.0
// Pictures in memory, for tests to look at.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "libstyle/base/bytes.h"

namespace libstyle {

// Red, green, blue, alpha; colours multiplied by alpha, so that what is transparent is equal.
using Pixel = std::array<std::uint8_t, 4>;

struct Raster {
  std::size_t width = 0, height = 0;
  std::vector<Pixel> pixels;  // row by row

  Raster() = default;
  Raster(std::size_t w, std::size_t h, Pixel filling = {})
      : width(w), height(h), pixels(w * h, filling) {}

  Pixel& at(std::size_t x, std::size_t y) { return pixels[y * width + x]; }
  const Pixel& at(std::size_t x, std::size_t y) const { return pixels[y * width + x]; }

  friend bool operator==(const Raster&, const Raster&) = default;
};

// Read by libpng through Cairo, not by our own code. Throws Error for what is no PNG.
Raster decode_png(std::string_view bytes);
void encode_png(ByteSink& sink, const Raster& image);

// From and to files by name.
Raster load_image(const std::string& name);
void save_image(const std::string& name, const Raster& image);

// The pixel as it looks on white.
Pixel on_white(Pixel pixel);

}  // namespace libstyle
