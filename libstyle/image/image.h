// SPDX-License-Identifier: Apache-2.0
// Pictures as the library sees them: samples in memory, whatever file they came from.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace libstyle {

// Rows from the top, pixels from the left, the channels of a pixel side by side. One channel is
// grey, two are grey and alpha, three are red, green and blue, four those and alpha; a guide may
// have any number. Integer samples of a file lie in 0 .. 1; those of a float file are as they are.
// Alpha is straight, not multiplied into the colours.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> samples;

  Image() = default;
  Image(int columns, int rows, int channel_count)
      : width(columns),
        height(rows),
        channels(channel_count),
        samples(static_cast<std::size_t>(columns) * rows * channel_count) {}

  bool empty() const { return samples.empty(); }
  bool has_alpha() const { return channels == 2 || channels == 4; }
  int color_channels() const { return has_alpha() ? channels - 1 : channels; }

  // The samples of the pixel in column x of row y, which must be inside.
  std::span<float> pixel(int x, int y) { return {&samples[index(x, y)], size()}; }
  std::span<const float> pixel(int x, int y) const { return {&samples[index(x, y)], size()}; }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  std::size_t size() const { return static_cast<std::size_t>(channels); }
  std::size_t index(int x, int y) const {
    return (static_cast<std::size_t>(y) * width + x) * channels;
  }
};

}  // namespace libstyle
