// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/gaussian_pyramid.h"

#include <algorithm>
#include <cmath>

#include "libstyle/base/error.h"
#include "libstyle/geometry/gaussian.h"

namespace libstyle {
namespace {

void validate(const GaussianPyramidParams& params) {
  if (!(params.finest_spacing > 0) || !std::isfinite(params.finest_spacing)) {
    throw Error("pyramid: finest_spacing must be a positive number");
  }
  if (!(params.ratio > 1) || !std::isfinite(params.ratio)) {
    throw Error("pyramid: ratio must be greater than 1");
  }
  if (params.levels < 1 || params.levels > 64) {
    throw Error("pyramid: levels must be between 1 and 64");
  }
}

}  // namespace

std::vector<GaussianPyramidLevel> gaussian_pyramid(const SampledCurve& curve,
                                                   const GaussianPyramidParams& params,
                                                   std::span<const double> kept) {
  validate(params);
  // Blurring moves vertices only, so there must be enough of them.
  const SampledCurve finest = resample(curve, params.finest_spacing, kept);
  std::vector<GaussianPyramidLevel> levels = {{params.finest_spacing, 0, finest}};
  double scale = 1;
  for (int above = 1; above < params.levels; ++above) {
    scale *= params.ratio;
    GaussianPyramidLevel level;
    level.spacing = params.finest_spacing * scale;
    level.sigma = params.finest_spacing * std::sqrt(scale * scale - 1);
    level.curve = finest;
    level.curve.polyline = gaussian_blur(finest.polyline, level.sigma);
    level.curve = resample(level.curve, level.spacing, kept);
    levels.push_back(std::move(level));
  }
  std::ranges::reverse(levels);
  return levels;
}

}  // namespace libstyle
