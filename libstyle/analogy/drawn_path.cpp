// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/drawn_path.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "libstyle/analogy/carried_values.h"
#include "libstyle/analogy/smooth_curve.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/cubic_fit.h"
#include "libstyle/geometry/path_segments.h"

namespace libstyle {
namespace {

constexpr double kLeastScale = 0.05;  // of a style, for what is seen of it

// A subpath that stays as it is.
SmoothCurve kept(const Subpath& old, const FlattenedSubpath& flat) {
  SmoothCurve result;
  if (old.segments.empty()) {
    result.path.move_to(flat.polyline.points.front());
    result.lengths = {0};
    return result;
  }
  double length = 0;
  result.path.move_to(old.segments.front().curve.p0);
  result.lengths.push_back(0);
  for (const PathSegment& segment : old.segments) {
    const CubicBezier& c = segment.curve;
    if (segment.end_vertex < segment.start_vertex) break;  // the line that Z draws
    segment.straight ? result.path.line_to(c.p3) : result.path.cubic_to(c.p1, c.p2, c.p3);
    length += arc_length(c);
    result.lengths.push_back(length);
  }
  if (old.closed) result.path.close();
  return result;
}

// The curve, or the strokes that it is drawn as.
std::vector<SmoothCurve> smooth_strokes(const StyledCurve& drawn, double length,
                                        const FitTolerances& tolerances) {
  if (drawn.strokes.empty()) return {smooth_curve(drawn, length, tolerances)};
  std::vector<SmoothCurve> result;
  for (const DrawnLine& stroke : drawn.strokes) {
    StyledCurve single;
    single.curve = stroke.curve;
    single.lengths = stroke.lengths;
    single.features = stroke.features;
    single.pinned = stroke.pinned;
    result.push_back(smooth_curve(single, length, tolerances));
  }
  return result;
}

std::size_t vertex_count(std::span<const Subpath> subpaths, std::size_t i, const Path& path) {
  const std::size_t end =
      i + 1 < subpaths.size() ? subpaths[i + 1].first_vertex : path.vertex_count();
  return end - subpaths[i].first_vertex;
}

Path joined(std::span<const SmoothCurve> strokes) {
  Path result;
  for (const SmoothCurve& stroke : strokes) result.append(stroke.path);
  return result;
}

class PathDrawer {
 public:
  PathDrawer(const PathRecord& old, const FlatPath& flat, const CurveAnalogy& style,
             const PathTask& task)
      : old_(old),
        old_subpaths_(subpaths(old.path)),
        flat_(flat),
        style_(style),
        task_(task),
        features_(style.example().features()) {
    for (const Channel& channel : old.along.channels) {
      along_.channels.push_back({channel.name, {}});
    }
    along_.extras = old.along.extras;
  }

  // Each subpath, in order.
  void draw(std::size_t i) {
    CurveTask task = task_.first;
    task.place += i;
    task.held = flat_.held[i];
    task.constraints = task_.constraints[i];
    if (task_.walks) task.before = &(*task_.walks)[i];
    StyledCurve drawn = style_.draw(flat_.subpaths[i].polyline, task);
    if (task_.walks) (*task_.walks)[i] = std::move(drawn.walks);

    const std::vector<SmoothCurve> strokes = smooth(i, drawn, !task.constraints.empty());
    for (const SmoothCurve& stroke : strokes) append_values_of(stroke, i, drawn);
    const Path written = joined(strokes);
    path_.append(written);
    measure(i, drawn, written);
  }

  // What became of it.
  PathMeasure put_into(PathRecord& record) {
    if (any_drawn_) features_.put(along_);
    record.path = std::move(path_);
    record.along = std::move(along_);
    record.shape.clear();
    return std::move(measure_);
  }

 private:
  double length_of(std::size_t i) const {
    const Polyline& line = flat_.subpaths[i].polyline;
    return line.points.empty() ? 0 : arc_length(line);
  }

  std::vector<SmoothCurve> smooth(std::size_t i, const StyledCurve& drawn,
                                  bool is_constrained) const {
    const double length = length_of(i);
    const bool bends = is_constrained && !drawn.too_long && length > 0;
    if (!is_styled(drawn) && !bends) return {kept(old_subpaths_[i], flat_.subpaths[i])};
    const FitTolerances tolerances =
        fit_tolerances(style_.example(), std::max(drawn.mean_scale, kLeastScale));
    return smooth_strokes(drawn, length, tolerances);
  }

  static bool is_styled(const StyledCurve& drawn) { return !drawn.runs.empty(); }

  void append_values_of(const SmoothCurve& stroke, std::size_t i, const StyledCurve& drawn) {
    append_values(along_, old_.along, flat_.subpaths[i], stroke.lengths);
    if (is_styled(drawn)) {
      features_.append(stroke);
      any_drawn_ = true;
    } else {
      features_.append_kept(along_, drawn, stroke.lengths.size());
    }
  }

  void measure(std::size_t i, const StyledCurve& drawn, const Path& written) {
    if (task_.is_measured) {
      CurveMeasure curve = measure_curve(flat_.subpaths[i].polyline, flat_.held[i], drawn, written);
      curve.vertices_before = vertex_count(old_subpaths_, i, old_.path);
      measure_.curves.push_back(std::move(curve));
    }
    const double length = length_of(i);
    measure_.length += length;
    measure_.too_long = measure_.too_long || drawn.too_long;
    if (!is_styled(drawn) || drawn.mean_scale < 0.5) measure_.small_length += length;
  }

  const PathRecord& old_;
  std::vector<Subpath> old_subpaths_;
  const FlatPath& flat_;
  const CurveAnalogy& style_;
  const PathTask& task_;
  Path path_;
  AlongValues along_;
  StyledFeatures features_;
  bool any_drawn_ = false;
  PathMeasure measure_;
};

}  // namespace

PathMeasure draw_path(PathRecord& record, const FlatPath& flat, const CurveAnalogy& style,
                      const PathTask& task) {
  if (flat.too_long) return {.too_long = true, .curves = {}};
  PathDrawer drawer(record, flat, style, task);
  for (std::size_t i = 0; i < flat.subpaths.size(); ++i) drawer.draw(i);
  return drawer.put_into(record);
}

}  // namespace libstyle
