// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/drawing_constraints.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "libstyle/analogy/line_constraints.h"
#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/segment_grid.h"

namespace libstyle {
namespace {

// A constraint on one subpath, and who wants it.
struct Placed {
  const PathRecord* path = nullptr;
  std::size_t subpath = 0;
  bool closed = false;
  CurveConstraint constraint;
  std::string name;
  std::size_t line = 0;  // 0: it is not in the drawing
};

// A path as one length.
class PathLengths {
 public:
  explicit PathLengths(std::span<const FlattenedSubpath> subpaths) {
    for (const FlattenedSubpath& subpath : subpaths) {
      curves_.push_back(subpath.polyline);
      lengths_.push_back(arc_length(subpath.polyline));
      total_ += lengths_.back();
    }
  }

  // The subpath and the fraction of its length. Nothing if the path has no length.
  std::optional<std::pair<std::size_t, double>> at(double t) const {
    if (!(total_ > 0)) return std::nullopt;
    double left = t * total_;
    std::size_t last = 0;
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      if (lengths_[i] == 0) continue;
      if (left <= lengths_[i] * (1 + kSameLength)) return {{i, std::min(left / lengths_[i], 1.0)}};
      left -= lengths_[i];
      last = i;
    }
    return {{last, 1}};
  }

  std::optional<std::pair<std::size_t, double>> nearest_to(Point p) {
    if (!(total_ > 0)) return std::nullopt;
    if (!grid_) {
      std::vector<Polyline> with_length = curves_;
      for (std::size_t i = 0; i < with_length.size(); ++i) {
        if (lengths_[i] == 0) with_length[i].points.clear();
      }
      grid_.emplace(with_length);
    }
    const std::optional<NearestPlace> place = grid_->nearest(p);
    if (!place) return std::nullopt;
    const std::size_t i = place->at.curve;
    const double length = ArcLength(curves_[i]).length_to(place->at.place);
    return {{i, std::min(length / lengths_[i], 1.0)}};
  }

 private:
  std::vector<Polyline> curves_;
  std::vector<double> lengths_;
  double total_ = 0;
  std::optional<SegmentGrid> grid_;
};

class ConstraintPlacer {
 public:
  explicit ConstraintPlacer(std::span<const ConstrainablePath> paths)
      : paths_(paths), placed_(paths.size()) {}

  // Returns whether the constraint has an effect.
  bool place(const ConstraintRecord& record, std::size_t path, const std::string& name) {
    if (paths_[path].subpaths.empty()) return false;
    PathLengths& lengths = lengths_.try_emplace(path, paths_[path].subpaths).first->second;
    const auto where = record.t ? lengths.at(*record.t) : lengths.nearest_to(record.position);
    if (!where) return false;
    if (record.weight && *record.weight == 0) return true;
    const auto& [subpath, t] = *where;
    placed_[paths_[path].group].push_back({paths_[path].record,
                                           subpath,
                                           paths_[path].subpaths[subpath].polyline.closed,
                                           {t, record.position, record.weight},
                                           name,
                                           record.line});
    return true;
  }

  std::vector<PathConstraints> finish() {
    std::vector<PathConstraints> result(paths_.size());
    for (std::size_t i = 0; i < paths_.size(); ++i) refuse_contradictions(i);
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      result[i].resize(paths_[i].subpaths.size());
      for (const Placed& placed : placed_[paths_[i].group]) {
        if (placed.subpath < result[i].size()) {
          result[i][placed.subpath].push_back(placed.constraint);
        }
      }
    }
    return result;
  }

 private:
  // Each hard constraint against the next on its subpath; on a closed one the last is next to the
  // first.
  void refuse_contradictions(std::size_t group) const {
    std::vector<Placed> hard;
    for (const Placed& placed : placed_[group]) {
      if (!placed.constraint.weight) hard.push_back(placed);
    }
    std::ranges::stable_sort(hard, {},
                             [](const Placed& p) { return std::pair(p.subpath, p.constraint.t); });
    for (std::size_t i = 0; i < hard.size(); ++i) {
      const Placed& one = hard[i];
      const bool is_last = i + 1 == hard.size() || hard[i + 1].subpath != one.subpath;
      if (is_last && !one.closed) continue;
      const Placed& next = is_last ? hard[first_of(hard, one.subpath)] : hard[i + 1];
      const double gap = next.constraint.t - one.constraint.t + (is_last ? 1 : 0);
      if (gap <= kSameLength && one.constraint.position != next.constraint.position) {
        refuse(one, next);
      }
    }
  }

  static std::size_t first_of(const std::vector<Placed>& hard, std::size_t subpath) {
    const auto at = std::ranges::lower_bound(hard, subpath, {}, &Placed::subpath);
    return static_cast<std::size_t>(at - hard.begin());
  }

  [[noreturn]] static void refuse(const Placed& a, const Placed& b) {
    const bool in_order = a.line == 0 ? b.line == 0 : b.line == 0 || a.line <= b.line;
    const Placed &first = in_order ? a : b, &second = in_order ? b : a;
    const auto wish = [](const Placed& placed) {
      return text_of(placed.constraint.position) + " (" + placed.name + ')';
    };
    throw Error(Place{{}, second.line},
                '#' + second.path->id + " cannot be in two places at once, " + wish(first) +
                    " and " + wish(second) + "; take one away or give it a weight");
  }

  std::span<const ConstrainablePath> paths_;
  std::vector<std::vector<Placed>> placed_;  // for each group
  std::map<std::size_t, PathLengths> lengths_;
};

}  // namespace

std::vector<PathConstraints> place_constraints(const Document& document,
                                               std::span<const AskedConstraint> asked,
                                               std::span<const ConstrainablePath> paths,
                                               const WarningHandler& warn) {
  ConstraintPlacer placer(paths);
  std::map<std::string_view, std::size_t> path_of;
  std::size_t next = 0;
  for (const Record& record : document.records) {
    if (const auto* path = std::get_if<PathRecord>(&record)) {
      if (next == paths.size() || paths[next].record != path) continue;
      if (!path->id.empty()) path_of.emplace(path->id, next);
      ++next;
    } else if (const auto* constraint = std::get_if<ConstraintRecord>(&record)) {
      const auto path_found = path_of.find(constraint->curve);
      if (path_found == path_of.end()) continue;
      placer.place(*constraint, path_found->second,
                   constraint->line > 0 ? "line " + std::to_string(constraint->line) : "a record");
    }
  }
  for (const auto& [constraint, name] : asked) {
    const auto path = path_of.find(constraint.curve);
    if (path != path_of.end() && placer.place(constraint, path->second, name)) continue;
    if (!warn) continue;
    Warning warning;
    warning.place.line = document.header.line;
    warning.message = name + " moves no line: no path that is drawn again has this id";
    warn(warning);
  }
  return placer.finish();
}

}  // namespace libstyle
