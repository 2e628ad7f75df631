// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/window.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "libstyle/image/lanes.h"

namespace libstyle::image {
namespace {

bool counts(FilteredPart part, int dx, int dy) {
  switch (part) {
    case FilteredPart::kBefore:
      return dy < 0 || (dy == 0 && dx < 0);
    case FilteredPart::kAround:
      return dx != 0 || dy != 0;
    case FilteredPart::kWhole:
      break;
  }
  return true;
}

// The weights of the pixels of one part, summing to 1; all 0 when none counts.
template <typename Counts>
std::vector<double> pixel_weights(int radius, Counts counts_there) {
  const int side = 2 * radius + 1;
  const double sigma = side / 4.0;
  std::vector<double> result;
  double sum = 0;
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      const double weight =
          counts_there(dx, dy) ? std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma)) : 0;
      result.push_back(weight);
      sum += weight;
    }
  }
  if (sum > 0) {
    for (double& weight : result) weight /= sum;
  }
  return result;
}

}  // namespace

WindowWeights make_window(const WindowSettings& settings) {
  const int radius = settings.radius;
  const int side = 2 * radius + 1;
  const int guides = static_cast<int>(settings.guide_shares.size());
  const int channels = guides + settings.filtered_channels;
  const auto guide = pixel_weights(radius, [&](int dx, int dy) {
    return !settings.guide_in_middle_only || (dx == 0 && dy == 0);
  });
  const auto filtered =
      pixel_weights(radius, [&](int dx, int dy) { return counts(settings.filtered, dx, dy); });

  WindowWeights window{radius, whole_lanes(side * channels), {}};
  window.weights.resize(static_cast<std::size_t>(side) * window.row_lanes);
  for (int pixel = 0; pixel < side * side; ++pixel) {
    float* weights = &window.weights[static_cast<std::size_t>(pixel / side) * window.row_lanes +
                                     static_cast<std::size_t>(pixel % side) * channels];
    for (int c = 0; c < guides; ++c) {
      weights[c] = static_cast<float>(guide[pixel] * settings.guide_shares[c]);
    }
    for (int c = 0; c < settings.filtered_channels; ++c) {
      weights[guides + c] = static_cast<float>(filtered[pixel] / settings.filtered_channels);
    }
  }
  return window;
}

WindowWeights clipped(const WindowWeights& window, int channels, int left, int top, int right,
                      int bottom) {
  WindowWeights result = window;
  const int radius = window.radius;
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      if (dx >= -left && dx <= right && dy >= -top && dy <= bottom) continue;
      std::fill_n(&result.weights[static_cast<std::size_t>(dy + radius) * window.row_lanes +
                                  static_cast<std::size_t>(dx + radius) * channels],
                  channels, 0.F);
    }
  }
  return result;
}

WindowWeights clipped_to(const FeaturePlane& target, const WindowWeights& window, int x, int y) {
  return clipped(window, target.channels(), x, y, target.width() - 1 - x, target.height() - 1 - y);
}

bool reaches_over(const FeaturePlane& target, const WindowWeights& window, int x, int y) {
  return x < window.radius || y < window.radius || x >= target.width() - window.radius ||
         y >= target.height() - window.radius;
}

float window_distance(const WindowWeights& window, const float* a, std::ptrdiff_t a_row,
                      const float* b, std::ptrdiff_t b_row) {
  const float* weights = window.weights.data();
  Lanes sum = all_lanes(0);
  for (int row = 2 * window.radius; row >= 0; --row) {
    for (int i = 0; i < window.row_lanes; i += kLanes) {
      const Lanes difference = load_lanes(a + i) - load_lanes(b + i);
      sum += load_lanes(weights + i) * difference * difference;
    }
    weights += window.row_lanes;
    a += a_row;
    b += b_row;
  }
  return sum_of_lanes(sum);
}

}  // namespace libstyle::image
