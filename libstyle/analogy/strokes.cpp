// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/strokes.h"

#include <algorithm>
#include <numeric>

#include "libstyle/analogy/correspondence.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/segment_grid.h"

namespace libstyle {
namespace {

constexpr std::size_t kPlaces = 64;       // of a stroke that are compared with lines
constexpr double kLeastStretch = 0.1;     // of the length of a stroke, along its line
constexpr double kStraightAlong = 0.5;    // of its length: less, and it goes across rather
constexpr double kLongestAcross = 0.005;  // of the length of the line

void reverse(SampledCurve& curve) {
  std::ranges::reverse(curve.polyline.points);
  std::ranges::reverse(curve.t);
  for (std::vector<double>& values : curve.channels) std::ranges::reverse(values);
}

Polyline part_of(const ArcLength& line, double from, double to) {
  Polyline part;
  part.points.push_back(line.point_at(from));
  for (std::size_t i = 0; i < line.polyline().points.size(); ++i) {
    const double length = line.cumulative()[i];
    if (length > from && length < to) part.points.push_back(line.polyline().points[i]);
  }
  part.points.push_back(line.point_at(to));
  return part;
}

}  // namespace

std::vector<std::size_t> lines_of_strokes(std::span<const Polyline> lines,
                                          std::span<const Polyline> strokes) {
  std::vector<SegmentGrid> grids;
  for (const Polyline& line : lines) grids.emplace_back(std::span(&line, 1));
  std::vector<std::size_t> result;
  for (const Polyline& stroke : strokes) {
    const Polyline places = resample_to_count(stroke, kPlaces);
    std::vector<double> distances;
    for (const SegmentGrid& grid : grids) {
      double sum = 0;
      for (const Point p : places.points) sum += grid.nearest(p)->distance;
      distances.push_back(sum);
    }
    result.push_back(
        static_cast<std::size_t>(std::ranges::min_element(distances) - distances.begin()));
  }
  return result;
}

SampledCurve laid_along(SampledCurve stroke, const Polyline& line) {
  const ArcLength along(line);
  const SegmentGrid grid({&line, 1});
  const auto length_at = [&](Point p) { return along.length_to(grid.nearest(p)->at.place); };
  double from = length_at(stroke.polyline.points.front());
  double to = length_at(stroke.polyline.points.back());
  if (from > to) {
    std::swap(from, to);
    reverse(stroke);
  }
  const double own = arc_length(stroke.polyline);
  const double least = std::min(kLeastStretch * own, kLongestAcross * along.total());
  if (to - from < least) {
    from = std::clamp((from + to - least) / 2, 0.0, along.total() - least);
    to = from + least;
  }
  if (to - from > kStraightAlong * own) {
    stroke.t = corresponding_lengths(stroke.polyline, part_of(along, from, to));
  } else {
    stroke.t = cumulative_lengths(stroke.polyline);
    for (double& t : stroke.t) t *= (to - from) / own;
  }
  for (double& t : stroke.t) t += from;
  return stroke;
}

std::vector<std::size_t> assign_lanes(std::span<const Lane::Stroke> strokes) {
  std::vector<std::size_t> order(strokes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return strokes[i].begin; });
  std::vector<double> ends;  // of the lanes
  std::vector<std::size_t> result(strokes.size());
  for (const std::size_t i : order) {
    const auto free =
        std::ranges::find_if(ends, [&](double end) { return end < strokes[i].begin; });
    result[i] = static_cast<std::size_t>(free - ends.begin());
    if (free == ends.end()) ends.push_back(0);
    ends[result[i]] = strokes[i].end;
  }
  return result;
}

}  // namespace libstyle
