// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/fitting_scale.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "libstyle/analogy/plain_lines.h"
#include "libstyle/analogy/style_grid.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/flatten.h"

namespace libstyle {
namespace {

constexpr double kRoomyLine = 3;  // times what the style needs

}  // namespace

double fitting_scale(std::span<const Path* const> paths, std::span<const ExamplePair> pairs,
                     const CurveAnalogyParameters& parameters) {
  CurveAnalogyParameters unscaled = parameters;
  unscaled.scale = 1;
  const Example example(pairs, unscaled);
  const double room = room_needed(example);
  const double corner_angle = parameters.corner_angle * std::numbers::pi / 180;
  std::vector<double> lengths;
  double total = 0;
  for (const Path* path : paths) {
    const Box box = path->control_box();
    const double size = std::max(box.width(), box.height());
    if (!(size > 0)) continue;
    for (const FlattenedSubpath& flat : flatten(*path, 0.01 * size)) {
      for (const PlainLine& line : split_into_lines(flat.polyline, corner_angle, 0.05 * size)) {
        lengths.push_back(arc_length(line.line));
        total += lengths.back();
      }
    }
  }
  std::ranges::sort(lengths);
  double sum = 0;
  for (const double length : lengths) {
    sum += length;
    if (sum >= total / 2) return length / (kRoomyLine * room);
  }
  return 1;
}

}  // namespace libstyle
