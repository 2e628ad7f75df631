// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/drawing.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

#include "libstyle/analogy/line_features.h"
#include "libstyle/analogy/smooth_curve.h"
#include "libstyle/base/number.h"
#include "libstyle/base/parallel.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/cubic_fit.h"
#include "libstyle/geometry/flatten.h"
#include "libstyle/geometry/junctions.h"
#include "libstyle/geometry/path_segments.h"

namespace libstyle {
namespace {

constexpr double kFlatness = 0.02;  // of a feature size: of what is drawn along
constexpr double kMeeting = 1e-3;   // of the drawing's diagonal: ends that near a line meet it

bool comes_before(const Path* a, const Path* b) {
  const auto key = [](Point p) { return std::tuple(p.x, p.y); };
  const auto points = std::lexicographical_compare_three_way(
      a->points().begin(), a->points().end(), b->points().begin(), b->points().end(),
      [&](Point p, Point q) { return key(p) <=> key(q); });
  if (points != 0) return points < 0;
  return std::ranges::lexicographical_compare(a->commands(), b->commands());
}

// ---- Values along curves --------------------------------------------------------------------

// Values at points of a curve, looked up by length.
class ValuesByLength {
 public:
  ValuesByLength(const FlattenedSubpath& flat)
      : lengths_(cumulative_lengths(flat.polyline)),
        places_(flat.places),
        goes_round_(flat.polyline.closed) {
    if (goes_round_) places_.push_back(flat.places.front());
  }

  std::vector<double> at(std::span<const double> lengths, std::span<const double> values) const {
    const std::vector<double> known = values_along(places_, values);
    if (known.size() == 1) return std::vector(lengths.size(), known.front());
    std::vector<double> result;
    for (double length : lengths) {
      if (goes_round_ && length > lengths_.back()) length -= lengths_.back();
      const auto after = std::ranges::upper_bound(lengths_, length);
      const auto i =
          std::clamp<std::ptrdiff_t>(after - lengths_.begin(), 1, std::ssize(lengths_) - 1);
      const auto b = static_cast<std::size_t>(i), a = b - 1;
      const double gap = lengths_[b] - lengths_[a];
      const double share = gap > 0 ? std::clamp((length - lengths_[a]) / gap, 0.0, 1.0) : 0;
      result.push_back(std::lerp(known[a], known[b], share));
    }
    return result;
  }

 private:
  std::vector<double> lengths_;
  std::vector<PathPlace> places_;
  bool goes_round_;
};

void append_values(AlongValues& result, const AlongValues& old, const FlattenedSubpath& flat,
                   std::span<const double> lengths) {
  if (old.empty()) return;
  const ValuesByLength along(flat);
  for (std::size_t i = 0; i < old.channels.size(); ++i) {
    const std::vector<double> values = along.at(lengths, old.channels[i].values);
    std::vector<double>& all = result.channels[i].values;
    all.insert(all.end(), values.begin(), values.end());
  }
  if (old.colors.empty()) return;
  const std::vector<Color> colors = map_channels(
      old.colors, [&](std::span<const double> values) { return along.at(lengths, values); });
  result.colors.insert(result.colors.end(), colors.begin(), colors.end());
}

// What the style says of its features, for all subpaths of a path.
class StyledFeatures {
 public:
  explicit StyledFeatures(std::span<const LineFeature> features)
      : features_(features), values_(features.size()) {}

  // The last subpath, drawn.
  void append(const SmoothCurve& fresh) {
    for (std::size_t i = 0; i < features_.size(); ++i) {
      values_[i].insert(values_[i].end(), fresh.features[i].begin(), fresh.features[i].end());
    }
  }

  // The last subpath, not drawn, or only bent: it keeps its own values, which are the last ones of
  // `along`, or gets those of the style.
  void append_kept(const AlongValues& along, const StyledCurve& kept, std::size_t vertices) {
    for (std::size_t i = 0; i < features_.size(); ++i) {
      const std::vector<double> own = feature_values(along, features_[i]);
      if (own.empty()) {
        values_[i].insert(values_[i].end(), vertices, kept.features[i].front());
      } else {
        values_[i].insert(values_[i].end(), own.end() - static_cast<std::ptrdiff_t>(vertices),
                          own.end());
      }
    }
  }

  void put(AlongValues& along) const { set_features(along, features_, values_); }

 private:
  std::span<const LineFeature> features_;
  std::vector<std::vector<double>> values_;
};

// ---- One path -------------------------------------------------------------------------------

struct PathMeasure {
  double length = 0;
  double small_length = 0;           // of curves with the style at less than half its size
  bool too_long = false;             // it, or one of its subpaths, stays as it is
  std::vector<CurveMeasure> curves;  // if they are wanted
};

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

// A path as lines, and where other lines end on them.
struct FlatPath {
  std::vector<FlattenedSubpath> subpaths;
  std::vector<std::vector<double>> held;  // for each subpath: lengths along it, rising
  bool too_long = false;                  // and therefore not flattened
};

FlatPath flatten_path(const Path& path, const CurveAnalogy& style) {
  const Box box = path.control_box();
  if (!(std::max(box.width(), box.height()) <= style.longest_curve())) return {{}, {}, true};
  FlatPath flat{flatten(path, kFlatness * style.example().feature_size()), {}, false};
  flat.held.resize(flat.subpaths.size());
  return flat;
}

// Finds the lines that end on the middle of others, and notes on the latter where.
void find_meetings(std::span<FlatPath> paths) {
  std::vector<Polyline> curves;
  std::vector<std::vector<double>*> held;
  Box box;
  for (FlatPath& path : paths) {
    for (std::size_t i = 0; i < path.subpaths.size(); ++i) {
      curves.push_back(path.subpaths[i].polyline);
      held.push_back(&path.held[i]);
      for (const Point p : curves.back().points) box.include(p);
    }
  }
  if (box.empty()) return;
  const double tolerance = kMeeting * distance(box.low, box.high);
  std::map<std::size_t, ArcLength> tables;
  for (const Junction& junction : find_junctions(curves, tolerance).junctions) {
    for (const JunctionMember& member : junction.members) {
      if (member.role != JunctionRole::kInterior) continue;
      const std::size_t curve = member.at.curve;
      const ArcLength& along = tables.try_emplace(curve, curves[curve]).first->second;
      held[curve]->push_back(along.length_to(member.at.place));
    }
  }
  for (std::vector<double>* lengths : held) std::ranges::sort(*lengths);
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

// What is wanted of one path, and of how it was drawn in the frame before.
struct PathTask {
  CurveTask first;  // of the first subpath, but for the places that it passes
  const PathConstraints& constraints;
  std::vector<LineWalks>* walks = nullptr;  // one for each subpath; null if there are no frames
  bool is_measured = false;
};

PathMeasure draw_path(PathRecord& record, const FlatPath& flat, const CurveAnalogy& style,
                      const PathTask& path_task) {
  PathMeasure measure;
  measure.too_long = flat.too_long;
  if (flat.too_long) return measure;
  const std::vector<FlattenedSubpath>& flats = flat.subpaths;
  const std::vector<Subpath> old = subpaths(record.path);
  AlongValues along;
  for (const Channel& channel : record.along.channels) along.channels.push_back({channel.name, {}});
  along.extras = record.along.extras;
  StyledFeatures features(style.example().features());
  bool any_drawn = false;
  Path path;
  for (std::size_t i = 0; i < flats.size(); ++i) {
    CurveTask task = path_task.first;
    task.place += i;
    task.held = flat.held[i];
    task.constraints = path_task.constraints[i];
    if (path_task.walks) task.before = &(*path_task.walks)[i];
    StyledCurve drawn = style.draw(flats[i].polyline, task);
    if (path_task.walks) (*path_task.walks)[i] = std::move(drawn.walks);
    const double length = flats[i].polyline.points.empty() ? 0 : arc_length(flats[i].polyline);
    const FitTolerances tolerances =
        fit_tolerances(style.example(), std::max(drawn.mean_scale, 0.05));
    const bool is_styled = !drawn.runs.empty();
    const bool stays = !is_styled && (task.constraints.empty() || drawn.too_long || length == 0);
    const std::vector<SmoothCurve> fresh =
        stays ? std::vector{kept(old[i], flats[i])} : smooth_strokes(drawn, length, tolerances);
    for (const SmoothCurve& stroke : fresh) {
      append_values(along, record.along, flats[i], stroke.lengths);
      if (is_styled) {
        features.append(stroke);
      } else {
        features.append_kept(along, drawn, stroke.lengths.size());
      }
    }
    const Path written = joined(fresh);
    path.append(written);
    if (path_task.is_measured) {
      CurveMeasure curve = measure_curve(flats[i].polyline, flat.held[i], drawn, written);
      curve.vertices_before = vertex_count(old, i, record.path);
      measure.curves.push_back(std::move(curve));
    }
    any_drawn = any_drawn || is_styled;
    measure.length += length;
    measure.too_long = measure.too_long || drawn.too_long;
    if (drawn.runs.empty() || drawn.mean_scale < 0.5) measure.small_length += length;
  }
  if (any_drawn) features.put(along);
  record.path = std::move(path);
  record.along = std::move(along);
  record.shape.clear();
  return measure;
}

// ---- A drawing --------------------------------------------------------------------------------

struct StyledPath {
  PathRecord* record;
  std::size_t style;            // kNone: it stays as it is
  const CurveAnalogy* analogy;  // null: it stays as it is
  // Strokes have no inside: the area keeps its shape, and its line becomes a record of its own.
  std::optional<PathRecord> line = std::nullopt;

  PathRecord& drawn() { return line ? *line : *record; }
};

bool is_painted(const std::optional<Paint>& paint) {
  return paint && !std::holds_alternative<NoPaint>(*paint);
}

// Parts a record that is to be drawn as strokes. An area without a line stays as it is.
void part_area_from_line(StyledPath& path) {
  if (!path.analogy || !path.analogy->example().has_strokes()) return;
  PathRecord& area = *path.record;
  if (!is_painted(area.style.fill)) return;
  if (!is_painted(area.style.stroke) && area.along.colors.empty()) {
    path.analogy = nullptr;
    return;
  }
  path.line = area;
  path.line->style.fill = NoPaint{};
  area.style.stroke = NoPaint{};
  area.along = {};
}

// The lines of areas get ids of their own: those of the areas with numbers behind.
void name_lines(const Document& document, std::span<StyledPath> paths) {
  std::unordered_set<std::string_view> taken;
  for (const Record& record : document.records) {
    if (const RecordBase* base = base_of(record)) taken.insert(base->id);
  }
  for (StyledPath& path : paths) {
    if (!path.line || path.line->id.empty()) continue;
    const std::string area = path.line->id + '~';
    int number = 2;
    while (taken.contains(area + std::to_string(number))) ++number;
    path.line->id = area + std::to_string(number);
  }
}

// Puts the lines of areas in front of them, or behind, as they were painted.
void insert_lines(Document& document, std::span<StyledPath> paths) {
  name_lines(document, paths);
  Records records;
  auto path = paths.begin();
  for (Record& record : document.records) {
    std::optional<PathRecord> line;
    if (std::holds_alternative<PathRecord>(record)) line = std::move((path++)->line);
    const bool below = line && line->style.stroke_first;
    if (below) records.emplace_back(std::move(*line));
    records.push_back(std::move(record));
    if (line && !below) records.emplace_back(std::move(*line));
  }
  document.records = std::move(records);
}

std::vector<StyledPath> styled_paths(Document& document, const StylePlan& plan) {
  std::vector<StyledPath> result;
  for (std::size_t i = 0; i < document.records.size(); ++i) {
    auto* record = std::get_if<PathRecord>(&document.records[i]);
    if (!record) continue;
    const std::size_t style = plan.style_of_record[i];
    const bool stays = style == StylePlan::kNone;
    result.push_back({record, style, stays ? nullptr : plan.styles[style].analogy});
  }
  return result;
}

// For each path the first one that is the same curve, whatever its style.
std::vector<std::size_t> first_equals(std::span<const StyledPath> paths) {
  std::map<const Path*, std::size_t, decltype(&comes_before)> seen(&comes_before);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    result.push_back(seen.try_emplace(&paths[i].record->path, i).first->second);
  }
  return result;
}

// Of paths that stay only the ends matter, which the eye of any style sees exactly.
std::vector<FlatPath> flatten_paths(std::span<const StyledPath> paths, const CurveAnalogy& any) {
  std::vector<FlatPath> result;
  for (const StyledPath& path : paths) {
    result.push_back(flatten_path(path.record->path, path.analogy ? *path.analogy : any));
  }
  find_meetings(result);
  return result;
}

std::vector<PathConstraints> find_constraints(const Document& document,
                                              std::span<const StyledPath> paths,
                                              std::span<const std::size_t> places,
                                              std::span<const FlatPath> flat,
                                              const DrawingOptions& options) {
  std::vector<ConstrainablePath> constrainable;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    constrainable.push_back({paths[i].record, {}, places[i]});
    if (paths[i].analogy) constrainable.back().subpaths = flat[i].subpaths;
  }
  return place_constraints(document, options.constraints, constrainable, options.warn);
}

void warn_if_long(std::span<const StyledPath> paths, std::span<const PathMeasure> measures,
                  const WarningHandler& warn) {
  for (std::size_t i = 0; warn && i < paths.size(); ++i) {
    if (!measures[i].too_long) continue;
    std::string message = "is too long for its style, which draws lines of up to ";
    append_number(message, std::floor(paths[i].analogy->longest_curve()));
    message += " px; it stays as it is";
    warn({{.file = "", .line = paths[i].record->line},
          std::string(given_id(paths[i].record->id)),
          message});
  }
}

void warn_if_small(std::span<const StyledPath> paths, std::span<const PathMeasure> measures,
                   std::size_t style, const std::string& name, const WarningHandler& warn) {
  double length = 0, small = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].style != style) continue;
    length += measures[i].length;
    small += measures[i].small_length;
  }
  if (!warn || !(small > length / 2)) return;
  Warning warning;
  warning.message = name + " is large for this drawing: ";
  append_number(warning.message, std::round(100 * small / length));
  warning.message +=
      " % of its lines have it at less than half its size; draw it at a smaller scale";
  warn(warning);
}

void summarize_styles(std::span<const StyledPath> paths, std::span<PathMeasure> measures,
                      const StylePlan& plan, std::vector<StyleMeasures>& result) {
  for (std::size_t style = 0; style < plan.styles.size(); ++style) {
    if (!plan.styles[style].analogy) continue;
    std::vector<CurveMeasure> curves;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      if (paths[i].style == style)
        std::ranges::move(measures[i].curves, std::back_inserter(curves));
    }
    result[style] = summarize(curves, plan.styles[style].analogy->example());
  }
}

}  // namespace

void draw_again(Document& document, const StylePlan& plan, const DrawingOptions& options) {
  if (options.measures) options.measures->assign(plan.styles.size(), {});
  std::vector<StyledPath> paths = styled_paths(document, plan);
  const std::vector<std::size_t> places = first_equals(paths);
  const auto any = std::ranges::find_if(paths, [](const StyledPath& path) { return path.analogy; });
  std::vector<FlatPath> flat(paths.size());
  if (any != paths.end()) flat = flatten_paths(paths, *any->analogy);
  for (StyledPath& path : paths) part_area_from_line(path);
  const std::vector<PathConstraints> constraints =
      find_constraints(document, paths, places, flat, options);
  if (options.walks) options.walks->resize(paths.size());
  std::vector<PathMeasure> measures(paths.size());
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(paths.size(), options.threads, [&](std::size_t i) {
    StyledPath& path = paths[i];
    const std::size_t place = places[i];
    if (path.analogy) {
      const bool alike = path.style == paths[place].style;
      const FlatPath& own = flat[alike ? place : i];
      const PathTask task{{.place = place << 24,
                           .held = {},
                           .variant = options.variant,
                           .constraints = {},
                           .before = nullptr,
                           .coherence = options.coherence},
                          constraints[i],
                          options.walks ? &(*options.walks)[i] : nullptr,
                          options.measures != nullptr};
      if (task.walks) task.walks->resize(own.subpaths.size());
      measures[i] = draw_path(path.drawn(), own, *path.analogy, task);
    }
    if (!options.progress) return;
    const std::lock_guard lock(mutex);
    options.progress(static_cast<double>(++done) / static_cast<double>(paths.size()));
  });
  if (options.measures) summarize_styles(paths, measures, plan, *options.measures);
  warn_if_long(paths, measures, options.warn);
  for (std::size_t style = 0; style < plan.styles.size(); ++style) {
    warn_if_small(paths, measures, style, plan.styles[style].name, options.warn);
  }
  const auto has_line = [](const StyledPath& path) { return path.line.has_value(); };
  if (std::ranges::any_of(paths, has_line)) insert_lines(document, paths);
}

void draw_again(Document& document, const CurveAnalogy& style, const DrawingOptions& options) {
  StylePlan plan;
  plan.styles.push_back({.analogy = &style});
  plan.style_of_record.resize(document.records.size(), 0);
  draw_again(document, plan, options);
}

}  // namespace libstyle
