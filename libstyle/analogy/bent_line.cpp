// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/bent_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "libstyle/analogy/warp.h"
#include "libstyle/geometry/arc_length.h"

namespace libstyle {
namespace {

constexpr double kLeastWidth = 3;         // feature sizes: as what is drawn is moved (assembly.cpp)
constexpr double kWidthPerOffset = 1.25;  // a Gaussian of that width is never steeper than 1/2
constexpr double kSpacing = 0.25;         // feature sizes
constexpr double kMostVertices = 1 << 22;
constexpr double kSamePlace = 1e-9;  // of the length

// The vertices of the line and the places of the bends, rising. A vertex all but in the place of a
// bend gives way to it: a segment of almost no length would have any direction.
std::vector<double> fixed_lengths(const ArcLength& along, std::span<const Bend> bends) {
  std::vector<double> result;
  const double margin = kSamePlace * along.total();
  auto next = bends.begin();
  for (const double length : along.cumulative()) {
    while (next != bends.end() && next->length <= length + margin) {
      result.push_back(next++->length);
    }
    if (result.empty() || length > result.back() + margin) result.push_back(length);
  }
  return result;
}

// More between those that are far apart.
std::vector<double> lengths_to_move(const ArcLength& along, std::span<const Bend> bends,
                                    double spacing) {
  const std::vector<double> fixed = fixed_lengths(along, bends);
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < fixed.size(); ++i) {
    const double gap = fixed[i + 1] - fixed[i];
    const auto pieces = static_cast<std::size_t>(std::max(1.0, std::ceil(gap / spacing)));
    for (std::size_t k = 0; k < pieces; ++k) {
      result.push_back(fixed[i] + gap * static_cast<double>(k) / static_cast<double>(pieces));
    }
  }
  result.push_back(fixed.back());
  return result;
}

std::vector<WarpTarget> warp_targets(std::span<const Bend> bends, double width,
                                     std::optional<double> period) {
  std::vector<WarpTarget> targets;
  for (const Bend& bend : bends) {
    const double widening = std::max(1.0, kWidthPerOffset * norm(bend.offset) / width);
    targets.push_back({bend.length, bend.offset, widening});
    if (!period) continue;
    targets.push_back({bend.length - *period, bend.offset, widening});
    targets.push_back({bend.length + *period, bend.offset, widening});
  }
  return targets;
}

// Where `x` is between rising `from`, as far between `to`.
double carried(const std::vector<double>& from, const std::vector<double>& to, double x) {
  const auto at = std::ranges::lower_bound(from, x);
  if (at == from.end()) return to.back();
  const auto i = static_cast<std::size_t>(at - from.begin());
  if (i == 0 || *at == x) return to[i];
  return std::lerp(to[i - 1], to[i], (x - from[i - 1]) / (from[i] - from[i - 1]));
}

}  // namespace

BentLine::BentLine(const Polyline& line) : line_(line) {}

BentLine::BentLine(const Polyline& line, std::span<const Bend> bends, double feature) {
  const ArcLength along(line);
  const double width = kLeastWidth * feature;
  const double spacing = std::max(kSpacing * feature, along.total() / kMostVertices);
  std::optional<double> period;
  if (line.closed) period = along.total();
  const Warp warp(warp_targets(bends, width, period), width);
  line_.closed = line.closed;
  plain_ = lengths_to_move(along, bends, spacing);
  for (const double length : plain_) {
    line_.points.push_back(along.point_at(length) + warp.at(length));
  }
  if (line.closed) line_.points.pop_back();  // the first again
  bent_ = cumulative_lengths(line_);
}

double BentLine::bent_length(double plain) const {
  return plain_.empty() ? plain : carried(plain_, bent_, plain);
}

double BentLine::plain_length(double bent) const {
  if (plain_.empty()) return bent;
  if (line_.closed && bent > bent_.back()) {
    return plain_.back() + carried(bent_, plain_, bent - bent_.back());
  }
  return carried(bent_, plain_, bent);
}

}  // namespace libstyle
