// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/drawing_measures.h"

#include <algorithm>
#include <utility>

#include "libstyle/analogy/style_summary.h"
#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/flatten.h"
#include "libstyle/geometry/segment_grid.h"
#include "libstyle/geometry/turning_statistics.h"

namespace libstyle {
namespace {

constexpr double kFlatness = 1e-5;  // of the size of what is written: finer than what is measured
constexpr double kStepsOfExample = 1200;
constexpr double kSmall = 0.5;

std::vector<Polyline> polylines_of(const Path& path) {
  const Box box = path.control_box();
  const double size = std::max(box.width(), box.height());
  std::vector<Polyline> result;
  if (!(size > 0)) return result;
  for (FlattenedSubpath& flat : flatten(path, kFlatness * size)) {
    result.push_back(std::move(flat.polyline));
  }
  return result;
}

// A single one, or its strokes.
std::vector<Polyline> drawn_curves(const StyledCurve& drawn) {
  if (drawn.strokes.empty()) return {drawn.curve};
  std::vector<Polyline> result;
  for (const DrawnLine& stroke : drawn.strokes) result.push_back(stroke.curve);
  return result;
}

double farthest_from(const SegmentGrid& grid, std::span<const Point> points) {
  double most = 0;
  for (const Point p : points) {
    if (const auto nearest = grid.nearest(p)) most = std::max(most, nearest->distance);
  }
  return most;
}

// How often a line is cut in the middle does not matter: one half of everything, and the other.
std::pair<std::vector<Polyline>, std::vector<Polyline>> halves(std::span<const Polyline> curves) {
  std::pair<std::vector<Polyline>, std::vector<Polyline>> result;
  for (const Polyline& curve : curves) {
    const ArcLength along(curve);
    const PolylinePlace middle = along.place_at(along.total() / 2);
    const Point cut = point_at(curve, middle);
    const auto after = curve.points.begin() + static_cast<std::ptrdiff_t>(middle.segment) + 1;
    Polyline first{{curve.points.begin(), after}, false}, second{{cut}, false};
    first.points.push_back(cut);
    second.points.insert(second.points.end(), after, curve.points.end());
    result.first.push_back(std::move(first));
    result.second.push_back(std::move(second));
  }
  return result;
}

std::optional<double> distance_if_long(std::span<const Polyline> a, std::span<const Polyline> b,
                                       double spacing) {
  try {
    return turning_distance(a, b, spacing);
  } catch (const Error&) {
    return std::nullopt;  // one of them is too short
  }
}

void measure_runs(StyleMeasures& result, std::span<const CurveMeasure> curves,
                  const Example& example) {
  std::vector<std::size_t> sizes;
  std::vector<bool> seen(example.state_count());
  for (const CurveMeasure& curve : curves) {
    for (const ChainRun& run : curve.runs) {
      sizes.push_back(run.steps);
      const std::size_t end = std::min<std::size_t>(run.origin + run.steps, seen.size());
      for (std::size_t state = run.origin; state < end; ++state) seen[state] = true;
    }
  }
  const auto states = static_cast<double>(example.state_count());
  result.runs = sizes.size();
  result.coverage = static_cast<double>(std::ranges::count(seen, true)) / states;
  if (sizes.empty()) return;
  std::ranges::sort(sizes);
  const auto median = static_cast<double>(sizes[sizes.size() / 2]);
  const auto longest = static_cast<double>(sizes.back());
  result.median_run = median * example.step();
  result.longest_run = longest * example.step();
  result.median_run_share = median / states;
  result.longest_run_share = longest / states;
}

void measure_likeness(StyleMeasures& result, std::span<const CurveMeasure> curves,
                      const Example& example) {
  const std::vector<Polyline> filtered = filtered_curves(example);
  double length = 0;
  for (const Polyline& curve : filtered) length += arc_length(curve);
  const double spacing = length / kStepsOfExample;
  std::vector<Polyline> drawn;
  for (const CurveMeasure& curve : curves) {
    drawn.insert(drawn.end(), curve.drawn.begin(), curve.drawn.end());
  }
  result.turning_distance = distance_if_long(filtered, drawn, spacing);
  const auto [first, second] = halves(filtered);
  result.turning_distance_of_halves = distance_if_long(first, second, spacing);
}

}  // namespace

CurveMeasure measure_new_curve(const StyledCurve& drawn, const Path& written) {
  StyledCurve moved = drawn;
  const Vector move = written.points().front() - drawn.curve.points.front();
  for (Point& p : moved.curve.points) p += move;
  return measure_curve(moved.curve, {}, moved, written);
}

CurveMeasure measure_curve(const Polyline& plain, std::span<const double> held,
                           const StyledCurve& drawn, const Path& written) {
  CurveMeasure measure;
  measure.vertices_after = written.vertex_count();
  measure.is_kept = drawn.runs.empty();
  if (plain.points.empty()) return measure;
  const ArcLength along(plain);
  measure.length = along.total();
  if (measure.is_kept) return measure;
  measure.mean_scale = drawn.mean_scale;
  measure.runs = drawn.runs;
  const std::vector<Polyline> lines = polylines_of(written);
  const SegmentGrid grid(lines);
  for (Polyline& curve : drawn_curves(drawn)) {
    measure.fit_distance = std::max(measure.fit_distance, farthest_from(grid, curve.points));
    for (Point& p : curve.points) p *= 1 / drawn.mean_scale;
    measure.drawn.push_back(std::move(curve));
  }
  std::vector<Point> places;
  for (const double length : held) places.push_back(along.point_at(length));
  measure.held = held.size();
  measure.held_distance = farthest_from(grid, places);
  if (plain.closed) return measure;
  if (drawn.strokes.empty()) {
    const std::vector<Point> vertices = written.vertices();
    measure.end_distance = std::max(distance(plain.points.front(), vertices.front()),
                                    distance(plain.points.back(), vertices.back()));
  } else {
    const Point ends[] = {plain.points.front(), plain.points.back()};
    measure.end_distance = farthest_from(grid, ends);
  }
  return measure;
}

StyleMeasures summarize(std::span<const CurveMeasure> curves, const Example& example) {
  StyleMeasures result;
  double scaled = 0, small = 0;
  for (const CurveMeasure& curve : curves) {
    ++result.curves;
    result.kept += curve.is_kept ? 1 : 0;
    result.length += curve.length;
    result.vertices_before += curve.vertices_before;
    result.vertices_after += curve.vertices_after;
    result.held += curve.held;
    result.end_distance = std::max(result.end_distance, curve.end_distance);
    result.held_distance = std::max(result.held_distance, curve.held_distance);
    result.fit_distance = std::max(result.fit_distance, curve.fit_distance);
    scaled += curve.is_kept ? 0 : curve.length * curve.mean_scale;
    small += curve.is_kept || curve.mean_scale < kSmall ? curve.length : 0;
  }
  if (result.length > 0) {
    result.mean_scale = scaled / result.length;
    result.small_share = small / result.length;
  }
  measure_runs(result, curves, example);
  measure_likeness(result, curves, example);
  return result;
}

}  // namespace libstyle
