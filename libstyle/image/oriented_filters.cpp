// SPDX-License-Identifier: Apache-2.0
#include "libstyle/image/oriented_filters.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "libstyle/base/parallel.h"

namespace libstyle::image {
namespace {

constexpr int kRadius = 4;
constexpr int kSide = 2 * kRadius + 1;
constexpr int kDirections = 4;
constexpr double kDeviation = 1.2;

using Kernel = std::array<double, kSide * kSide>;

// The third derivative of exp(-r^2 / 2) along u is (3 u - u^3) exp(-r^2 / 2).
Kernel third_derivative(double angle) {
  Kernel kernel{};
  double sum = 0;
  for (int y = -kRadius; y <= kRadius; ++y) {
    for (int x = -kRadius; x <= kRadius; ++x) {
      const double u = (x * std::cos(angle) + y * std::sin(angle)) / kDeviation;
      const double squared_radius = (x * x + y * y) / (kDeviation * kDeviation);
      const double value = (3 * u - u * u * u) * std::exp(-squared_radius / 2);
      kernel[(y + kRadius) * kSide + x + kRadius] = value;
      sum += value * value;
    }
  }
  for (double& value : kernel) value /= std::sqrt(sum);
  return kernel;
}

}  // namespace

Image oriented_responses(const Image& luminance, int threads) {
  assert(luminance.channels == 1);
  std::array<Kernel, kDirections> kernels;
  for (int i = 0; i < kDirections; ++i) {
    kernels[i] = third_derivative(i * std::numbers::pi / kDirections);
  }
  Image result(luminance.width, luminance.height, kDirections);
  parallel_for(static_cast<std::size_t>(result.height), threads, [&](std::size_t index) {
    const int y = static_cast<int>(index);
    for (int x = 0; x < result.width; ++x) {
      std::array<double, kDirections> sums{};
      for (int dy = -kRadius; dy <= kRadius; ++dy) {
        const int row = std::clamp(y + dy, 0, luminance.height - 1);
        for (int dx = -kRadius; dx <= kRadius; ++dx) {
          const double value = luminance.pixel(std::clamp(x + dx, 0, luminance.width - 1), row)[0];
          const int place = (dy + kRadius) * kSide + dx + kRadius;
          for (int i = 0; i < kDirections; ++i) sums[i] += kernels[i][place] * value;
        }
      }
      const auto pixel = result.pixel(x, y);
      for (int i = 0; i < kDirections; ++i) pixel[i] = static_cast<float>(sums[i]);
    }
  });
  return result;
}

}  // namespace libstyle::image
