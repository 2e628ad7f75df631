// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/junctions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/box.h"

namespace libstyle {
namespace {

constexpr double kDiagonalShare = 0.01;
constexpr double kMedianLengthShare = 0.25;

// An end's own neighbourhood on its curve, in tolerances.
constexpr double kOwnReach = 3;

struct CurveEnd {
  CurvePlace at;
  JunctionRole role;
  Point position;
};

double automatic_tolerance(std::span<const Polyline> curves) {
  Box box;
  std::vector<double> lengths;
  for (const Polyline& curve : curves) {
    for (const Point point : curve.points) box.include(point);
    const double length = arc_length(curve);
    if (length > 0) lengths.push_back(length);
  }
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::ranges::nth_element(lengths, middle);
  const double diagonal = norm({box.width(), box.height()});
  return std::min(kDiagonalShare * diagonal, kMedianLengthShare * *middle);
}

std::vector<CurveEnd> ends_of(std::span<const Polyline> curves) {
  std::vector<CurveEnd> ends;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].closed || arc_length(curves[i]) == 0) continue;
    const std::size_t last = segment_count(curves[i]) - 1;
    ends.push_back({{i, {0, 0}}, JunctionRole::kStart, curves[i].points.front()});
    ends.push_back({{i, {last, 1}}, JunctionRole::kEnd, curves[i].points.back()});
  }
  return ends;
}

// Groups of numbers that are joined in pairs.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t representative(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(std::size_t a, std::size_t b) {
    a = representative(a);
    b = representative(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  // Each group's members, rising; groups by their first member.
  std::vector<std::vector<std::size_t>> take() {
    std::map<std::size_t, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < parent_.size(); ++i) groups[representative(i)].push_back(i);
    std::vector<std::vector<std::size_t>> result;
    for (auto& [first, members] : groups) result.push_back(std::move(members));
    return result;
  }

 private:
  std::vector<std::size_t> parent_;
};

std::vector<std::vector<std::size_t>> groups_of_ends(const std::vector<CurveEnd>& ends,
                                                     double tolerance) {
  std::vector<Polyline> points;
  for (const CurveEnd& end : ends) points.push_back({{end.position}, false});
  const SegmentGrid grid(points);
  Groups groups(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (const NearestPlace& near : grid.within(ends[i].position, tolerance)) {
      groups.join(i, near.at.curve);
    }
  }
  return groups.take();
}

class JunctionFinder {
 public:
  JunctionFinder(std::span<const Polyline> curves, double tolerance)
      : tolerance_(tolerance), grid_(curves), ends_(ends_of(curves)) {
    for (const Polyline& curve : curves) lengths_.push_back(cumulative_lengths(curve));
  }

  JunctionGraph find() const {
    JunctionGraph graph;
    graph.tolerance = tolerance_;
    for (const std::vector<std::size_t>& group : groups_of_ends(ends_, tolerance_)) {
      Junction junction = junction_of(group);
      if (junction.members.size() > 1) graph.junctions.push_back(std::move(junction));
    }
    std::ranges::sort(graph.junctions, {},
                      [&](const Junction& junction) { return order(junction.members.front()); });
    list_by_curve(graph);
    return graph;
  }

 private:
  double length_at(const CurvePlace& at) const {
    const std::vector<double>& lengths = lengths_[at.curve];
    return std::lerp(lengths[at.place.segment], lengths[at.place.segment + 1], at.place.fraction);
  }

  std::tuple<std::size_t, double, JunctionRole> order(const JunctionMember& member) const {
    return {member.at.curve, length_at(member.at), member.role};
  }

  Junction junction_of(const std::vector<std::size_t>& group) const {
    Junction junction;
    for (const std::size_t i : group) {
      junction.members.push_back({ends_[i].at, ends_[i].role});
      junction.position += ends_[i].position / static_cast<double>(group.size());
    }
    const std::map<std::size_t, NearestPlace> interiors = interiors_near(group);
    const NearestPlace* nearest = nullptr;
    for (const auto& [curve, place] : interiors) {
      junction.members.push_back({place.at, JunctionRole::kInterior});
      if (!nearest || place.distance < nearest->distance) nearest = &place;
    }
    if (nearest) junction.position = nearest->position;
    std::ranges::sort(junction.members, {}, [&](const auto& member) { return order(member); });
    return junction;
  }

  // For each curve that comes near one of the ends with its interior, the nearest place.
  std::map<std::size_t, NearestPlace> interiors_near(const std::vector<std::size_t>& group) const {
    std::map<std::size_t, NearestPlace> result;
    for (const std::size_t i : group) {
      for (const NearestPlace& near : grid_.within(ends_[i].position, tolerance_)) {
        if (lengths_[near.at.curve].back() == 0 || is_own_end(near.at, group)) continue;
        const auto [known, is_new] = result.try_emplace(near.at.curve, near);
        if (!is_new && near.distance < known->second.distance) known->second = near;
      }
    }
    return result;
  }

  // Whether a place is next to an end of the same curve that is in the group.
  bool is_own_end(const CurvePlace& at, const std::vector<std::size_t>& group) const {
    return std::ranges::any_of(group, [&](std::size_t i) {
      return ends_[i].at.curve == at.curve &&
             std::abs(length_at(ends_[i].at) - length_at(at)) <= kOwnReach * tolerance_;
    });
  }

  void list_by_curve(JunctionGraph& graph) const {
    std::vector<std::vector<std::pair<double, std::size_t>>> along(lengths_.size());
    for (std::size_t i = 0; i < graph.junctions.size(); ++i) {
      for (const JunctionMember& member : graph.junctions[i].members) {
        along[member.at.curve].emplace_back(length_at(member.at), i);
      }
    }
    for (auto& places : along) {
      std::ranges::sort(places);
      std::vector<std::size_t>& indices = graph.junctions_of_curve.emplace_back();
      for (const auto& [length, junction] : places) indices.push_back(junction);
    }
  }

  double tolerance_;
  SegmentGrid grid_;
  std::vector<CurveEnd> ends_;
  std::vector<std::vector<double>> lengths_;
};

}  // namespace

JunctionGraph find_junctions(std::span<const Polyline> curves, std::optional<double> tolerance) {
  if (tolerance && !(*tolerance >= 0 && std::isfinite(*tolerance))) {
    throw Error("junctions: tolerance must be a number that is not negative");
  }
  return JunctionFinder(curves, tolerance.value_or(automatic_tolerance(curves))).find();
}

}  // namespace libstyle
