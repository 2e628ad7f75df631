// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/style_grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "libstyle/analogy/sweep.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/polygon.h"

namespace libstyle {
namespace {

// By trial on outlines of letters and rectangles: a side of six feature sizes shows two or three
// features, and with fewer it no longer reads as the style.
constexpr double kFeaturesPerLine = 6;
constexpr double kReachesPerLine = 6;
// Bends of a radius below twice the reach of the style begin to fold, and below one they do.
constexpr double kRadiusPerReach = 2;
constexpr double kRadiusPerFeature = 1.5;
constexpr double kNodesPerFeature = 4;
constexpr double kMostNodes = 1 << 20;

std::size_t wrapped(std::ptrdiff_t i, std::size_t count, bool closed) {
  const auto n = static_cast<std::ptrdiff_t>(count);
  if (closed) return static_cast<std::size_t>(((i % n) + n) % n);
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, n - 1));
}

// The least of the values within `reach` nodes: a bend matters a little before it begins.
std::vector<double> least_nearby(const std::vector<double>& values, std::ptrdiff_t reach,
                                 bool closed) {
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    double least = values[i];
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
      least = std::min(least,
                       values[wrapped(static_cast<std::ptrdiff_t>(i) + k, values.size(), closed)]);
    }
    result[i] = least;
  }
  return result;
}

std::vector<double> mean_nearby(const std::vector<double>& values, std::ptrdiff_t reach,
                                bool closed) {
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    double sum = 0;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
      sum += values[wrapped(static_cast<std::ptrdiff_t>(i) + k, values.size(), closed)];
    }
    result[i] = sum / static_cast<double>(2 * reach + 1);
  }
  return result;
}

// Where x lies between rising `keys`, and how far; x outside goes on from the first or last pair.
std::pair<std::size_t, double> locate(const std::vector<double>& keys, double x) {
  const auto after = std::upper_bound(keys.begin() + 1, keys.end() - 1, x);
  const auto i = static_cast<std::size_t>(after - keys.begin()) - 1;
  return {i, (x - keys[i]) / (keys[i + 1] - keys[i])};
}

}  // namespace

double room_needed(const Example& example) {
  return std::max(kFeaturesPerLine * example.feature_along(), kReachesPerLine * example.reach());
}

StyleGrid::StyleGrid(const Polyline& line, const Example& example,
                     const CurveAnalogyParameters& parameters) {
  const double total = arc_length(line);
  const double smallest = parameters.smallest_scale;
  line_scale_ = std::clamp(total / room_needed(example), smallest, 1.0);
  const double spacing = line_scale_ * example.feature_along() / kNodesPerFeature;
  const auto nodes = static_cast<std::size_t>(std::clamp(total / spacing, 8.0, kMostNodes)) + 1;
  for (std::size_t i = 0; i < nodes; ++i) {
    lengths_.push_back(total * static_cast<double>(i) / static_cast<double>(nodes - 1));
  }
  scales_.assign(nodes, line_scale_);
  if (smallest < line_scale_ && parameters.invariance == Invariance::kRotate) {
    measure_bends(line, example, smallest);
  }
  count_steps(example.step());
}

void StyleGrid::measure_bends(const Polyline& line, const Example& example, double smallest) {
  const double feature = line_scale_ * example.feature_along();
  const Sweep sweep(line, 0, feature / 2, Invariance::kRotate);
  const double radius_per_scale =
      std::max(kRadiusPerReach * example.reach(), kRadiusPerFeature * example.feature_along());
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    double turn = 0;
    for (const double half : {-0.5, 0.5}) {
      const double middle = lengths_[i] + half * feature;
      turn += turning_angle(sweep.direction_at(middle - 0.5 * feature),
                            sweep.direction_at(middle + 0.5 * feature));
    }
    const double radius = 2 * feature / std::max(std::abs(turn), 1e-9);
    scales_[i] = std::clamp(radius / radius_per_scale, smallest, line_scale_);
  }
  const auto reach = static_cast<std::ptrdiff_t>(kNodesPerFeature);
  scales_ = least_nearby(scales_, reach, line.closed);
  for (int pass = 0; pass < 2; ++pass) scales_ = mean_nearby(scales_, reach / 2, line.closed);
}

void StyleGrid::count_steps(double step) {
  coordinates_.assign(lengths_.size(), 0.0);
  for (std::size_t i = 1; i < lengths_.size(); ++i) {
    const double pace = (1 / scales_[i - 1] + 1 / scales_[i]) / (2 * step);
    coordinates_[i] = coordinates_[i - 1] + pace * (lengths_[i] - lengths_[i - 1]);
  }
  const double whole = std::max(1.0, std::round(coordinates_.back()));
  steps_ = static_cast<std::size_t>(whole);
  const double stretch = whole / coordinates_.back();
  for (double& x : coordinates_) x *= stretch;
}

double StyleGrid::mean_scale() const {
  double sum = 0;
  for (std::size_t i = 1; i < scales_.size(); ++i) sum += (scales_[i - 1] + scales_[i]) / 2;
  return sum / static_cast<double>(scales_.size() - 1);
}

double StyleGrid::length_at(double x) const {
  const auto [i, share] = locate(coordinates_, x);
  return std::lerp(lengths_[i], lengths_[i + 1], share);
}

double StyleGrid::coordinate_at(double length) const {
  const auto [i, share] = locate(lengths_, length);
  return std::lerp(coordinates_[i], coordinates_[i + 1], share);
}

double StyleGrid::scale_at(double x) const {
  const auto [i, share] = locate(coordinates_, x);
  return std::lerp(scales_[i], scales_[i + 1], std::clamp(share, 0.0, 1.0));
}

}  // namespace libstyle
