// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/drawing.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "libstyle/analogy/drawn_path.h"
#include "libstyle/analogy/flat_paths.h"
#include "libstyle/analogy/stroke_records.h"
#include "libstyle/base/number.h"
#include "libstyle/base/parallel.h"

namespace libstyle {
namespace {

bool comes_before(const Path* a, const Path* b) {
  const auto key = [](Point p) { return std::tuple(p.x, p.y); };
  const auto points = std::lexicographical_compare_three_way(
      a->points().begin(), a->points().end(), b->points().begin(), b->points().end(),
      [&](Point p, Point q) { return key(p) <=> key(q); });
  if (points != 0) return points < 0;
  return std::ranges::lexicographical_compare(a->commands(), b->commands());
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
  insert_lines(document, paths);
}

void draw_again(Document& document, const CurveAnalogy& style, const DrawingOptions& options) {
  StylePlan plan;
  plan.styles.push_back({.analogy = &style});
  plan.style_of_record.resize(document.records.size(), 0);
  draw_again(document, plan, options);
}

}  // namespace libstyle
