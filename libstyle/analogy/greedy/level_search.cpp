// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/level_search.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"

namespace libstyle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Closed forms are this exact, of the sum of squares.
constexpr double kRounding = 1e-12;

constexpr std::size_t kMostSources = 2;

std::vector<double> parameters_of(std::span<const CurveConstraint> constraints) {
  std::vector<double> result;
  for (const CurveConstraint& constraint : constraints) result.push_back(constraint.t);
  return result;
}

void append(DrawnLevel& drawn, Point position, double t, std::size_t source, Vector rotation) {
  drawn.curve.polyline.points.push_back(position);
  drawn.curve.t.push_back(t);
  drawn.sources.push_back(source);
  drawn.rotations.push_back(rotation);
}

void reverse(DrawnLevel& drawn) {
  std::ranges::reverse(drawn.curve.polyline.points);
  std::ranges::reverse(drawn.curve.t);
  std::ranges::reverse(drawn.sources);
  std::ranges::reverse(drawn.rotations);
}

}  // namespace

LevelSearch::LevelSearch(const LevelExample& example, LevelTask task,
                         const SearchParameters& parameters)
    : example_(example),
      parameters_(parameters),
      task_(std::move(task)),
      penalty_(1 + parameters.coherence /
                       (parameters.coherence_of_finest ? kFinestSpacing : example.spacing())),
      drawn_(example.shape().size()),
      targets_(example.source_count(), Neighborhood(example.shape().size())),
      is_scored_(example.size()) {
  assert(task_.targets.size() == example.source_count());
  assert(example.source_count() <= kMostSources);
}

// ---- Growing (sections 3.1 and 3.3) -------------------------------------------------------------

DrawnLevel LevelSearch::grow_along_target(const RandomStream& random) {
  const SampledCurve domain = resample(task_.targets[0], parameters_.step * example_.spacing(),
                                       parameters_of(task_.constraints));
  const ArcLength along(domain.polyline);
  DrawnLevel drawn;
  for (std::size_t i = 0; i < domain.size(); ++i) {
    const double length = along.cumulative()[i];
    GrowthStep step{domain.t[i], 0, false};
    if (i > 0) step.gap = example_.growth() * (length - along.cumulative()[i - 1]);
    step.ends_allowed =
        !domain.polyline.closed && along.total() - length < example_.shape().half_width();
    grow(drawn, step, false, random);
  }
  drawn.curve.polyline.closed = domain.polyline.closed;
  return drawn;
}

DrawnLevel LevelSearch::grow_freely(double length, const RandomStream& random) {
  DrawnLevel drawn = begin_freely(length, random);
  if (task_.constraints.empty()) {
    grow_to_length(drawn, length, random);
    return drawn;
  }
  grow_to_end(drawn, length, false, random);
  reverse(drawn);
  grow_to_end(drawn, length, true, random);
  reverse(drawn);
  return drawn;
}

// A copied piece half a neighborhood long, or what of it fits between the ends and up to the second
// constraint. The vertex of the first constraint lies on it.
DrawnLevel LevelSearch::begin_freely(double length, const RandomStream& random) const {
  const double spacing = example_.spacing();
  const auto run = static_cast<std::size_t>(std::ceil(example_.shape().half_width() / spacing)) + 1;
  std::vector<std::size_t> starts;
  for (std::size_t j = 0; j + 2 * run < example_.size(); ++j) {
    if (example_.curve_of(j) == example_.curve_of(j + 2 * run)) starts.push_back(j);
  }
  const std::size_t start = starts[random.below(0, starts.size())];

  std::size_t before = 0, after = run - 1;  // vertices on either side of the constraint
  double t_middle = 0;
  Vector shift;
  if (!task_.constraints.empty()) {
    t_middle = task_.constraints[0].t;
    double room = 1 - t_middle;
    if (task_.constraints.size() > 1) room = task_.constraints[1].t - t_middle;
    const double step = spacing / length;
    after = std::min(after, static_cast<std::size_t>(std::max(0.0, std::ceil(room / step) - 1)));
    before = std::min(run - 1 - after, static_cast<std::size_t>(t_middle / step));
    shift = task_.constraints[0].position - example_.filtered(start + before).origin;
  }
  DrawnLevel drawn;
  for (std::size_t i = 0; i <= before + after; ++i) {
    const double steps = static_cast<double>(i) - static_cast<double>(before);
    append(drawn, example_.filtered(start + i).origin + shift,
           i == before ? t_middle : t_middle + steps * spacing / length, start + i, {1, 0});
  }
  return drawn;
}

void LevelSearch::grow_to_length(DrawnLevel& drawn, double length, const RandomStream& random) {
  const double gap = parameters_.step * example_.spacing();
  const double most = parameters_.longest_growth * (length / gap + 1);
  double drawn_length = arc_length(drawn.curve.polyline);
  while (drawn_length < length) {
    const Point before = drawn.curve.polyline.points.back();
    grow(drawn, {drawn.curve.t.back() + gap / length, gap, false}, false, random);
    drawn_length += distance(before, drawn.curve.polyline.points.back());
    if (static_cast<double>(drawn.curve.size()) > most) {
      throw Error("the search does not get on: take another seed or a longer example");
    }
  }
}

// Onwards from the last vertex, over all constraints that follow, to t = 1, or 0 if backward.
void LevelSearch::grow_to_end(DrawnLevel& drawn, double length, bool backward,
                              const RandomStream& random) {
  const double sign = backward ? -1 : 1, end = backward ? 0 : 1;
  const double step = parameters_.step * example_.spacing() / length;
  std::vector<double> stops = {end};
  for (const CurveConstraint& constraint : task_.constraints) {
    if (sign * (constraint.t - drawn.curve.t.back()) > 0) stops.push_back(constraint.t);
  }
  while (sign * (end - drawn.curve.t.back()) > 0) {
    const double from = drawn.curve.t.back();
    double to = from + sign * step;
    for (const double stop : stops) {
      if (sign * (stop - from) > 0 && sign * (to - stop) > 0) to = stop;
    }
    grow(drawn, {to, std::abs(to - from) * length, false}, backward, random);
  }
}

void LevelSearch::grow(DrawnLevel& drawn, const GrowthStep& step, bool backward,
                       const RandomStream& random) {
  Query query;
  query.t = step.t;
  query.ends_allowed = step.ends_allowed;
  query.backward = backward;
  const std::size_t count = drawn.curve.size();
  if (count > 0) {
    query.neighbors.push_back(
        {drawn.curve.polyline.points.back(), drawn.sources.back(), !backward});
  }
  drawn_.sample_beyond_end(drawn.curve.polyline, step.gap, example_.shape());
  if (backward) drawn_.reverse(example_.shape());
  sample_targets(step.t);
  const Candidate chosen = choose(query, random, count);
  append(drawn, chosen.position, step.t, chosen.place, chosen.rotation);
}

// ---- Refining ----------------------------------------------------------------------------------

void LevelSearch::refine(DrawnLevel& drawn, bool backward, const RandomStream& random) {
  const std::size_t count = drawn.curve.size();
  for (std::size_t step = 0; step < count; ++step) {
    const std::size_t i = backward ? count - 1 - step : step;
    Query query;
    query.t = drawn.curve.t[i];
    query.backward = backward;
    query.source = drawn.sources[i];
    set_neighbors(query, drawn, i, backward);
    const bool last = !drawn.curve.polyline.closed && i + 1 == count;
    drawn_.sample(drawn.curve.polyline, last ? PolylinePlace{i - 1, 1} : PolylinePlace{i, 0},
                  example_.shape(), false);
    sample_targets(query.t);
    const Candidate chosen = choose(query, random, i);
    drawn.curve.polyline.points[i] = chosen.position;
    drawn.sources[i] = chosen.place;
    drawn.rotations[i] = chosen.rotation;
  }
}

void LevelSearch::set_neighbors(Query& query, const DrawnLevel& drawn, std::size_t vertex,
                                bool backward) const {
  const std::size_t count = drawn.curve.size();
  const bool closed = drawn.curve.polyline.closed;
  const auto add = [&](std::size_t i, bool before) {
    if (drawn.sources[i] == kNoPlace) return;
    query.neighbors.push_back({drawn.curve.polyline.points[i], drawn.sources[i], before});
  };
  const bool both = parameters_.coherence_both_ways;
  if ((both || !backward) && (vertex > 0 || closed)) {
    add(vertex > 0 ? vertex - 1 : count - 1, true);
  }
  if ((both || backward) && (vertex + 1 < count || closed)) {
    add(vertex + 1 < count ? vertex + 1 : 0, false);
  }
}

double LevelSearch::cost_of(const DrawnLevel& drawn, std::size_t vertex) {
  Query query;
  query.t = drawn.curve.t[vertex];
  const bool last = !drawn.curve.polyline.closed && vertex + 1 == drawn.curve.size();
  drawn_.sample(drawn.curve.polyline,
                last ? PolylinePlace{vertex - 1, 1} : PolylinePlace{vertex, 0}, example_.shape(),
                false);
  sample_targets(query.t);
  return evaluate(query, drawn.sources[vertex], kInfinity, &drawn.curve.polyline.points[vertex])
      .cost;
}

// ---- Choosing ----------------------------------------------------------------------------------

void LevelSearch::sample_targets(double t) {
  screened_ = {drawn_.view()};
  for (std::size_t p = 0; p < targets_.size(); ++p) {
    const SampledCurve& target = task_.targets[p];
    targets_[p].sample(target.polyline, place_at_parameter(target, t), example_.shape());
    if (example_.source_weight(p) > 0) screened_.push_back(targets_[p].view());
  }
  collect_constraints(t);
}

void LevelSearch::collect_constraints(double t) {
  real_constraints_.clear();
  hard_position_ = nullptr;
  for (const CurveConstraint& constraint : task_.constraints) {
    if (constraint.t != t) continue;
    if (constraint.weight) {
      real_constraints_.push_back({*constraint.weight, 1, constraint.position});
    } else {
      hard_position_ = &constraint.position;
    }
  }
}

LevelSearch::Candidate LevelSearch::choose(const Query& query, const RandomStream& random,
                                           std::uint64_t place) {
  example_.screen().lower_bounds(screened_, screened_places_);
  best_ = kInfinity;
  scored_.clear();
  score_guesses(query);
  score_likely(query);
  for (const Candidate& candidate : scored_) is_scored_[candidate.place] = 0;

  std::erase_if(scored_, [&](const Candidate& c) { return !(c.cost <= limit()); });
  if (scored_.empty()) {
    throw Error(
        "no place of the example can be compared: give a longer example, or a smaller "
        "least_overlap");
  }
  std::ranges::sort(scored_, {}, &Candidate::place);
  return scored_[random.below(place, scored_.size())];
}

// The places that copies go on to, and the one the screen likes best: a low limit from the start.
void LevelSearch::score_guesses(const Query& query) {
  if (query.source != kNoPlace) score(query, query.source);
  for (const Neighbor& neighbor : query.neighbors) {
    const std::size_t j = neighbor.before ? neighbor.source + 1 : neighbor.source - 1;
    if (j < example_.size()) score(query, j);
  }
  score(query, screened_places_.likeliest);
}

// Everything that the bounds leave, in the order of the places.
void LevelSearch::score_likely(const Query& query) {
  const double reach = reach_of_copies(query);
  for (std::size_t j = 0; j < screened_places_.bounds.size(); ++j) {
    const double bound = static_cast<double>(screened_places_.bounds[j]);
    if (bound > limit()) continue;
    if (bound * penalty_ > limit() && !query.neighbors.empty() &&
        !could_be_coherent(query, j, reach)) {
      continue;
    }
    score(query, j);
  }
}

void LevelSearch::score(const Query& query, std::size_t j) {
  if (is_scored_[j] || !can_be_compared(j)) return;
  is_scored_[j] = 1;
  scored_.push_back(evaluate(query, j, limit()));
  scored_.back().place = j;
  best_ = std::min(best_, scored_.back().cost);
}

bool LevelSearch::can_be_compared(std::size_t j) const {
  const double least = parameters_.least_overlap;
  const NeighborhoodView drawn = drawn_.view();
  if (!drawn.empty() && overlap_of(example_.filtered(j), drawn, example_.shape()) < least) {
    return false;
  }
  for (std::size_t p = 0; p < targets_.size(); ++p) {
    if (overlap_of(example_.source(p, j), targets_[p].view(), example_.shape()) < least) {
      return false;
    }
  }
  return true;
}

// ---- One candidate -----------------------------------------------------------------------------

LevelSearch::Candidate LevelSearch::evaluate(const Query& query, std::size_t j, double limit,
                                             const Point* fixed) const {
  const NeighborhoodShape& shape = example_.shape();
  const double tangents = parameters_.tangent_weight;
  const NeighborhoodView a = example_.filtered(j), b = drawn_.view();
  Match drawn;
  Vector twist;
  if (!b.empty()) {
    drawn = match(a, b, shape, tangents);
    twist = drawn.scale() * drawn.twist;
  }
  std::array<Match, kMostSources> sources;
  for (std::size_t p = 0; p < targets_.size(); ++p) {
    sources[p] = match(example_.source(p, j), targets_[p].view(), shape, tangents);
    twist += std::max(example_.source_weight(p), 1.0) * sources[p].scale() * sources[p].twist;
  }
  const Vector rotation = best_rotation(twist, parameters_.rotate);

  double rough = b.empty() ? 0 : drawn.scale() * drawn.distance_for(rotation);
  double squares = drawn.squares;
  for (std::size_t p = 0; p < targets_.size(); ++p) {
    const double weight = example_.source_weight(p) * sources[p].scale();
    rough += weight * sources[p].distance_for(rotation);
    squares += weight * sources[p].squares;
  }
  if (rough - kRounding * squares > limit) return {};

  double cost = 0;
  if (!b.empty()) cost = drawn.scale() * shape_distance(a, b, drawn, rotation, shape, tangents);
  for (std::size_t p = 0; p < targets_.size(); ++p) {
    const double weight = example_.source_weight(p);
    if (weight == 0) continue;
    cost += weight * sources[p].scale() *
            shape_distance(example_.source(p, j), targets_[p].view(), sources[p], rotation, shape,
                           tangents);
  }

  std::array<VirtualConstraint, kMostSources + 1> virtuals;
  std::size_t count = 0;
  if (!b.empty()) {
    virtuals[count++] = {parameters_.position_weight, 1,
                         b.origin + drawn.mean_b - turn(rotation, drawn.mean_a)};
  }
  const double whole = 1 + drawn.weight;
  const Point mean_filtered = a.origin + (drawn.weight / whole) * drawn.mean_a;
  const Point begun = (drawn.weight / whole) * (b.origin + drawn.mean_b);
  for (std::size_t p = 0; p < targets_.size(); ++p) {
    const Point mean_source = example_.source(p, j).origin + sources[p].mean_a;
    const Point mean_target = targets_[p].view().origin + sources[p].mean_b;
    virtuals[count++] = {task_.offset_weight, 1 / whole,
                         mean_target + turn(rotation, mean_filtered - mean_source) - begun};
  }

  Point sum;
  double total = 0;
  const auto pull = [&](const VirtualConstraint& c) {
    sum += c.weight * c.share * c.target;
    total += c.weight * c.share * c.share;
  };
  std::for_each_n(virtuals.begin(), count, pull);
  std::ranges::for_each(real_constraints_, pull);
  if (!fixed) fixed = hard_position_;
  const Point p = fixed ? *fixed : sum / total;
  const auto pay = [&](const VirtualConstraint& c) {
    cost += c.weight * squared_norm(c.share * p - c.target);
  };
  std::for_each_n(virtuals.begin(), count, pay);
  std::ranges::for_each(real_constraints_, pay);

  if (!query.neighbors.empty() && !is_coherent(query, j, p)) {
    if (!query.ends_allowed && example_.is_near_end(j, query.backward)) return {};
    cost *= penalty_;
  }
  return {j, cost, p, rotation};
}

bool LevelSearch::is_coherent(const Query& query, std::size_t j, Point p) const {
  return std::ranges::any_of(query.neighbors, [&](const Neighbor& neighbor) {
    const std::size_t from = neighbor.before ? neighbor.source : j;
    const std::size_t to = neighbor.before ? j : neighbor.source;
    return example_.copied_length(from, to, distance(neighbor.position, p)).has_value();
  });
}

// How far from a neighbor a vertex can be that is worth its place: as far as the mean of what is
// drawn, half a neighborhood more, and what the limit lets it stray from the copied position.
double LevelSearch::reach_of_copies(const Query& query) const {
  const NeighborhoodView b = drawn_.view();
  if (hard_position_ || b.empty()) return kInfinity;
  Point sum;
  double total = 0;
  for (std::size_t k = b.begin; k < b.end; ++k) {
    if (!b.has_middle && k == example_.shape().middle()) continue;
    sum += example_.shape().weight(k) * b.positions[k];
    total += example_.shape().weight(k);
  }
  const Point mean = b.origin + sum / total;
  double farthest = 0;
  for (const Neighbor& neighbor : query.neighbors) {
    farthest = std::max(farthest, distance(mean, neighbor.position));
  }
  return farthest + example_.shape().half_width() +
         std::sqrt(limit() / parameters_.position_weight);
}

bool LevelSearch::could_be_coherent(const Query& query, std::size_t j, double reach) const {
  return std::ranges::any_of(query.neighbors, [&](const Neighbor& neighbor) {
    const auto ahead = example_.length_between(neighbor.source, j);
    if (!ahead) return false;
    const double on_example = neighbor.before ? *ahead : -*ahead;
    return on_example > 0 && on_example <= kLongestCopy * reach;
  });
}

}  // namespace libstyle
