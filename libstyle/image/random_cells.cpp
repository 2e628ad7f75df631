// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/random_cells.h"

#include <algorithm>
#include <cstddef>

#include "libstyle/base/random.h"

namespace libstyle::image {

void fill_with_random_cells(Level& level, int side, std::uint64_t seed, SourceIndices& sources) {
  constexpr std::uint64_t kStream = 1000;  // passes have the lower ones
  const RandomStream random(seed, kStream);
  const int width = level.target.width();
  const int height = level.target.height();
  sources.resize(std::size_t(width) * height);
  std::uint64_t cell = 0;
  for (int top = 0; top < height; top += side) {
    for (int left = 0; left < width; left += side, ++cell) {
      const PixelIndex place = level.places[random.below(cell, level.places.size())];
      const int example = level.example_of(place);
      const ExampleFrame& frame = level.frames[example];
      // The whole cell has to lie in the example, as far as that is large enough.
      const int from_x =
          std::clamp(level.examples.column(place), 0, std::max(0, frame.width - side));
      const int from_y = std::clamp(level.examples.row(place) - frame.first_row, 0,
                                    std::max(0, frame.height - side));
      for (int y = top; y < std::min(top + side, height); ++y) {
        for (int x = left; x < std::min(left + side, width); ++x) {
          const PixelIndex source =
              level.place(example, std::min(from_x + x - left, frame.width - 1),
                          std::min(from_y + y - top, frame.height - 1));
          sources[std::size_t(y) * width + x] = source;
          level.copy(source, level.target.index(x, y));
        }
      }
    }
  }
}

}  // namespace libstyle::image
