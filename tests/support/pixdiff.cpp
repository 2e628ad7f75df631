// SPDX-License-Identifier: Apache-2.0
#include "tests/support/pixdiff.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace libstyle {
namespace {

struct Range {
  int low = 255, high = 0;

  void include(int value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  int distance_to(int value) const { return std::max({0, low - value, value - high}); }
};

// The values of a channel around a pixel.
Range neighbours(const Raster& image, std::size_t x, std::size_t y, std::size_t channel) {
  Range range;
  for (std::size_t v = y > 0 ? y - 1 : 0; v <= std::min(y + 1, image.height - 1); ++v) {
    for (std::size_t u = x > 0 ? x - 1 : 0; u <= std::min(x + 1, image.width - 1); ++u) {
      range.include(image.at(u, v)[channel]);
    }
  }
  return range;
}

int difference(const Raster& a, const Raster& b, std::size_t x, std::size_t y, bool envelope) {
  if (a.at(x, y) == b.at(x, y)) return 0;
  int largest = 0;
  for (std::size_t channel = 0; channel < 4; ++channel) {
    const int in_a = a.at(x, y)[channel], in_b = b.at(x, y)[channel];
    const int here = !envelope ? std::abs(in_a - in_b)
                               : std::max(neighbours(b, x, y, channel).distance_to(in_a),
                                          neighbours(a, x, y, channel).distance_to(in_b));
    largest = std::max(largest, here);
  }
  return largest;
}

std::string size_of(const Raster& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

Pixel pale(Pixel pixel) {
  for (std::size_t i = 0; i < 3; ++i) pixel[i] = static_cast<std::uint8_t>(192 + pixel[i] / 4);
  return pixel;
}

void paste(Raster& target, const Raster& source, std::size_t left) {
  for (std::size_t y = 0; y < source.height; ++y) {
    for (std::size_t x = 0; x < source.width; ++x) {
      target.at(left + x, y) = on_white(source.at(x, y));
    }
  }
}

}  // namespace

DiffResult compare(const Raster& expected, const Raster& actual, const DiffBounds& bounds) {
  DiffResult result;
  const auto close = [&](std::size_t a, std::size_t b) {
    return std::max(a, b) - std::min(a, b) <= bounds.size_slack;
  };
  result.same_size = close(expected.width, actual.width) && close(expected.height, actual.height);
  if (!result.same_size) {
    result.summary = "sizes differ: " + size_of(expected) + " and " + size_of(actual);
    return result;
  }
  const std::size_t width = std::min(expected.width, actual.width);
  const std::size_t height = std::min(expected.height, actual.height);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const int here = difference(expected, actual, x, y, bounds.envelope);
      result.largest = std::max(result.largest, here);
      if (here > bounds.per_channel) ++result.bad;
    }
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, width * height));
  result.bad_share = static_cast<double>(result.bad) / count;
  result.passed = result.bad_share <= bounds.bad_share && result.largest <= bounds.hard_stop;
  char text[128];
  std::snprintf(text, sizeof text, "%zu of %zu pixels (%.3f %%) differ, by at most %d", result.bad,
                width * height, 100 * result.bad_share, result.largest);
  result.summary = text;
  return result;
}

Raster three_panels(const Raster& expected, const Raster& actual, const DiffBounds& bounds) {
  constexpr std::size_t kGap = 4;
  const std::size_t width = std::max(expected.width, actual.width);
  const std::size_t height = std::max(expected.height, actual.height);
  Raster panels(3 * width + 2 * kGap, height, {128, 128, 128, 255});
  paste(panels, expected, 0);
  paste(panels, actual, 2 * (width + kGap));
  for (std::size_t y = 0; y < std::min(expected.height, actual.height); ++y) {
    for (std::size_t x = 0; x < std::min(expected.width, actual.width); ++x) {
      const bool bad = difference(expected, actual, x, y, bounds.envelope) > bounds.per_channel;
      panels.at(width + kGap + x, y) =
          bad ? Pixel{255, 0, 0, 255} : pale(on_white(expected.at(x, y)));
    }
  }
  return panels;
}

}  // namespace libstyle
