// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/turning_statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "libstyle/base/error.h"
#include "libstyle/geometry/polygon.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {
namespace {

std::vector<Polyline> resampled(std::span<const Polyline> curves, double spacing) {
  std::vector<Polyline> result;
  for (const Polyline& curve : curves) result.push_back(resample(curve, spacing));
  return result;
}

std::vector<double> all_turning_angles(std::span<const Polyline> curves, std::size_t step) {
  std::vector<double> angles;
  for (const Polyline& curve : curves) {
    const std::vector<double> more = turning_angles(curve, step);
    angles.insert(angles.end(), more.begin(), more.end());
  }
  if (angles.empty()) {
    throw Error("a curve is too short to compare turning angles; choose a smaller spacing");
  }
  return angles;
}

}  // namespace

std::vector<double> turning_angles(const Polyline& evenly_sampled, std::size_t step) {
  assert(step > 0);
  const std::vector<Point>& points = evenly_sampled.points;
  const std::size_t count = points.size();
  std::vector<double> angles;
  if (count < 2 * step + 1) return angles;
  const std::size_t first = evenly_sampled.closed ? 0 : step;
  const std::size_t end = evenly_sampled.closed ? count : count - step;
  for (std::size_t i = first; i < end; ++i) {
    const Point before = points[(i + count - step) % count], after = points[(i + step) % count];
    angles.push_back(turning_angle(points[i] - before, after - points[i]));
  }
  return angles;
}

double wasserstein_distance(std::vector<double> a, std::vector<double> b) {
  assert(!a.empty() && !b.empty());
  std::ranges::sort(a);
  std::ranges::sort(b);
  // Walk both quantile functions together; positions are counted in units of 1 / (|a| |b|).
  double sum = 0;
  std::size_t i = 0, j = 0, position = 0;
  while (i < a.size() && j < b.size()) {
    const std::size_t next = std::min((i + 1) * b.size(), (j + 1) * a.size());
    sum += static_cast<double>(next - position) * std::abs(a[i] - b[j]);
    position = next;
    if (position == (i + 1) * b.size()) ++i;
    if (position == (j + 1) * a.size()) ++j;
  }
  return sum / (static_cast<double>(a.size()) * static_cast<double>(b.size()));
}

double turning_distance(std::span<const Polyline> a, std::span<const Polyline> b, double spacing,
                        std::span<const std::size_t> scales) {
  const std::vector<Polyline> even_a = resampled(a, spacing), even_b = resampled(b, spacing);
  double sum = 0;
  for (const std::size_t scale : scales) {
    sum +=
        wasserstein_distance(all_turning_angles(even_a, scale), all_turning_angles(even_b, scale));
  }
  return sum / static_cast<double>(scales.size());
}

double turning_distance(const Polyline& a, const Polyline& b, double spacing,
                        std::span<const std::size_t> scales) {
  return turning_distance({&a, 1}, {&b, 1}, spacing, scales);
}

}  // namespace libstyle
