// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/literal/literal_search.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <optional>

#include "libstyle/base/error.h"
#include "libstyle/geometry/gaussian_pyramid.h"
#include "tests/bench/literal/neighborhood.h"

namespace libstyle::literal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A virtual constraint: weight |share p - target|^2.
struct VirtualConstraint {
  double weight = 0;
  double share = 1;
  Point target;
};

// The control point before the one at hand.
struct Predecessor {
  Point position;
  std::optional<std::size_t> source;
};

// The control point at hand, and what is known around it.
struct Query {
  double t = 0;
  Neighborhood drawn;                 // b'_k, without the middle
  std::vector<Neighborhood> targets;  // b_k of each source pair
  std::optional<Predecessor> predecessor;
  bool ends_allowed = true;  // whether jumps may lead into the last half neighborhood of A'
};

struct Candidate {
  Point position;
  double cost = kInfinity;
};

// Everything about one level that the listings use without naming it.
class Search {
 public:
  Search(const Level& level, const SearchParameters& parameters)
      : level_(level),
        parameters_(parameters),
        weights_(binomial_weights(parameters.binomial_order, parameters.neighborhood_samples)),
        sample_spacing_(parameters.sample_spacing * level.spacing),
        filtered_(level.filtered.polyline) {
    for (const SourcePair& pair : level.sources) {
      examples_.emplace_back(pair.example.polyline);
      targets_.emplace_back(pair.target.polyline);
    }
    if (filtered_.total() < 3 * 2 * half_window()) {
      throw Error("the example is shorter than three neighborhoods");
    }
    if (level.has_floor) floor_ = measure_floor();
  }

  double half_window() const { return sample_spacing_ * static_cast<double>(weights_.size() / 2); }
  const ArcLength& filtered() const { return filtered_; }

  Neighborhood drawn_neighborhood(const ArcLength& drawn, double center) const {
    Neighborhood samples = sample(drawn, center);
    samples[samples.size() / 2].reset();
    return samples;
  }

  std::vector<Neighborhood> target_neighborhoods(double t) const {
    std::vector<Neighborhood> result;
    for (std::size_t p = 0; p < targets_.size(); ++p) {
      result.push_back(sample(targets_[p], length_at(targets_[p], level_.sources[p].target, t)));
    }
    return result;
  }

  // The loop over s_j and the choice: the position and the source of the new control point.
  std::pair<Point, std::size_t> choose(const Query& query, const RandomStream& random,
                                       std::uint64_t place) const {
    std::vector<Candidate> candidates;
    double least = kInfinity;
    for (std::size_t j = 0; j < level_.filtered.size(); ++j) {
      candidates.push_back(evaluate(query, j));
      least = std::min(least, candidates.back().cost);
    }
    std::vector<std::size_t> chosen;
    for (std::size_t j = 0; j < candidates.size(); ++j) {
      if (candidates[j].cost <= least * (1 + level_.epsilon) + floor_) chosen.push_back(j);
    }
    const std::size_t source = chosen[random.below(place, chosen.size())];
    if (const auto fixed = hard_position(query.t)) return {*fixed, source};
    return {candidates[source].position, source};
  }

  // The least cost of a place as it is.
  double least_cost(const Query& query, Point position) const {
    double least = kInfinity;
    for (std::size_t j = 0; j < level_.filtered.size(); ++j) {
      least = std::min(least, evaluate(query, j, position).cost);
    }
    return least;
  }

 private:
  Neighborhood sample(const ArcLength& curve, double center) const {
    return sample_neighborhood(curve, center, sample_spacing_, weights_.size());
  }

  static double length_at(const ArcLength& along, const SampledCurve& curve, double t) {
    return along.length_to(place_at_parameter(curve, t));
  }

  std::optional<Point> hard_position(double t) const {
    for (const CurveConstraint& constraint : level_.constraints) {
      if (constraint.t == t && !constraint.weight) return constraint.position;
    }
    return std::nullopt;
  }

  // One turn of the loop over s_j; `position`, if given, takes the place of the best p_j.
  Candidate evaluate(const Query& query, std::size_t j,
                     std::optional<Point> position = std::nullopt) const {
    const double s = level_.filtered.t[j];
    const Neighborhood a_filtered = sample(filtered_, filtered_.cumulative()[j]);
    std::vector<Neighborhood> a;
    for (std::size_t p = 0; p < examples_.size(); ++p) {
      a.push_back(sample(examples_[p], length_at(examples_[p], level_.sources[p].example, s)));
    }

    const Comparison drawn = compare(a_filtered, query.drawn, weights_, parameters_.tangent_weight);
    const bool begun =
        std::ranges::any_of(query.drawn, [](const auto& b) { return b.has_value(); });
    if (begun && drawn.overlap < parameters_.least_overlap) return {};
    std::complex<double> twist = drawn.scale * drawn.twist;
    std::vector<Comparison> sources;
    for (std::size_t p = 0; p < a.size(); ++p) {
      sources.push_back(compare(a[p], query.targets[p], weights_, parameters_.tangent_weight));
      if (sources[p].overlap < parameters_.least_overlap) return {};
      twist += std::fmax(level_.sources[p].weight, 1) * sources[p].scale * sources[p].twist;
    }
    const std::complex<double> rotation =
        parameters_.rotate && std::abs(twist) > 0 ? twist / std::abs(twist) : 1;

    double cost = drawn.scale * shape_distance(a_filtered, query.drawn, drawn, rotation, weights_,
                                               parameters_.tangent_weight);
    for (std::size_t p = 0; p < a.size(); ++p) {
      cost += level_.sources[p].weight * sources[p].scale *
              shape_distance(a[p], query.targets[p], sources[p], rotation, weights_,
                             parameters_.tangent_weight);
    }

    const Point middle = level_.filtered.polyline.points[j];
    std::vector<VirtualConstraint> constraints = real_constraints(query.t);
    if (begun) {
      constraints.push_back(
          {parameters_.position_weight, 1, turn(rotation, middle - drawn.mean_a) + drawn.mean_b});
    }
    add_offsets(constraints, drawn, middle, sources, rotation);

    Point p;
    double total = 0;
    for (const VirtualConstraint& c : constraints) {
      p += c.weight * c.share * c.target;
      total += c.weight * c.share * c.share;
    }
    p = position.value_or(hard_position(query.t).value_or(p / total));
    for (const VirtualConstraint& c : constraints) {
      cost += c.weight * squared_norm(c.share * p - c.target);
    }
    if (position) return {p, cost};

    if (query.predecessor && !is_coherent(*query.predecessor, j, p)) {
      if (!query.ends_allowed && leads_nowhere(j)) return {};
      cost *= 1 + parameters_.coherence / level_.spacing;
    }
    return {p, cost};
  }

  std::vector<VirtualConstraint> real_constraints(double t) const {
    std::vector<VirtualConstraint> result;
    for (const CurveConstraint& c : level_.constraints) {
      if (c.t == t && c.weight) result.push_back({*c.weight, 1, c.position});
    }
    return result;
  }

  // w_OFF |m p - r|^2 for each pair, r = mean b + R (mean a' - mean a) - what b' already weighs.
  void add_offsets(std::vector<VirtualConstraint>& constraints, const Comparison& drawn,
                   Point middle, const std::vector<Comparison>& sources,
                   std::complex<double> rotation) const {
    const double whole = 1 + drawn.weight;
    const Point mean_filtered = (middle + drawn.weight * drawn.mean_a) / whole;
    const Point begun = drawn.weight * drawn.mean_b / whole;
    for (const Comparison& source : sources) {
      const Point target = source.mean_b + turn(rotation, mean_filtered - source.mean_a) - begun;
      constraints.push_back({level_.offset_weight, 1 / whole, target});
    }
  }

  bool is_coherent(const Predecessor& before, std::size_t j, Point p) const {
    if (!before.source) return false;
    double on_example = filtered_.cumulative()[j] - filtered_.cumulative()[*before.source];
    if (level_.filtered.polyline.closed && on_example < 0) on_example += filtered_.total();
    const double on_drawn = distance(before.position, p);
    return j != *before.source && on_example > 0 && on_example >= 0.5 * on_drawn &&
           on_example <= 1.5 * on_drawn;
  }

  bool leads_nowhere(std::size_t j) const {
    return !level_.filtered.polyline.closed &&
           filtered_.cumulative()[j] > filtered_.total() - half_window();
  }

  // The quantile, over places of A' with whole neighborhoods, of the distance to the most similar
  // place that shares no part with it.
  double measure_floor() const {
    const double window = 2 * half_window();
    std::vector<double> nearest;
    for (std::size_t i = 0; i < level_.filtered.size(); ++i) {
      const Neighborhood own = sample(filtered_, filtered_.cumulative()[i]);
      if (!is_whole(own)) continue;
      double least = kInfinity;
      for (std::size_t j = 0; j < level_.filtered.size(); ++j) {
        double apart = std::abs(filtered_.cumulative()[j] - filtered_.cumulative()[i]);
        if (level_.filtered.polyline.closed) apart = std::min(apart, filtered_.total() - apart);
        const Neighborhood other = sample(filtered_, filtered_.cumulative()[j]);
        if (apart < window || !is_whole(other)) continue;
        const Comparison both = compare(other, own, weights_, parameters_.tangent_weight);
        const std::complex<double> rotation =
            parameters_.rotate && std::abs(both.twist) > 0 ? both.twist / std::abs(both.twist) : 1;
        least = std::min(least, shape_distance(other, own, both, rotation, weights_,
                                               parameters_.tangent_weight));
      }
      if (least < kInfinity) nearest.push_back(least);
    }
    if (nearest.empty()) return 0;
    std::ranges::sort(nearest);
    return nearest[static_cast<std::size_t>(parameters_.floor_quantile *
                                            static_cast<double>(nearest.size() - 1))];
  }

  static bool is_whole(const Neighborhood& samples) {
    return std::ranges::all_of(samples, [](const auto& sample) { return sample.has_value(); });
  }

  const Level& level_;
  const SearchParameters& parameters_;
  std::vector<double> weights_;
  double sample_spacing_;
  ArcLength filtered_;
  std::vector<ArcLength> examples_, targets_;
  double floor_ = 0;
};

std::vector<double> parameters_of(std::span<const CurveConstraint> constraints) {
  std::vector<double> result;
  for (const CurveConstraint& constraint : constraints) result.push_back(constraint.t);
  return result;
}

std::vector<CurveConstraint> softened(std::span<const CurveConstraint> constraints,
                                      int levels_above) {
  std::vector<CurveConstraint> result(constraints.begin(), constraints.end());
  for (CurveConstraint& constraint : result) {
    const double variance = (constraint.weight ? 1 / *constraint.weight : 0) + levels_above;
    constraint.weight = variance > 0 ? std::optional(1 / variance) : std::nullopt;
  }
  return result;
}

void set_randomness(Level& level, int index, const SearchParameters& parameters) {
  level.has_floor = index < parameters.random_levels;
  level.epsilon = level.has_floor ? parameters.epsilon : parameters.fine_epsilon;
}

CopiedCurve refine_often(const Level& level, CopiedCurve curve, int index, int passes,
                         const SearchParameters& parameters) {
  for (int pass = 1; pass <= passes; ++pass) {
    curve = refine_analogy(level, std::move(curve), parameters,
                           pass_random(parameters.seed, 0, index, pass));
  }
  return curve;
}

}  // namespace

CopiedCurve synthesize_curve(const Level& level, double length, const SearchParameters& parameters,
                             const RandomStream& random) {
  const Search search(level, parameters);
  const std::size_t points = level.filtered.size();
  const auto run = static_cast<std::size_t>(std::ceil(search.half_window() / level.spacing)) + 1;
  const std::size_t start = random.below(0, points - 2 * run);
  CopiedCurve drawn;
  double t_max = 0;
  for (std::size_t i = 0; i < run; ++i) {
    t_max = static_cast<double>(i) * level.spacing / length;
    drawn.curve.polyline.points.push_back(level.filtered.polyline.points[start + i]);
    drawn.curve.t.push_back(t_max);
    drawn.sources.push_back(start + i);
  }
  const double step = parameters.step * level.spacing;
  while (arc_length(drawn.curve.polyline) < length) {
    const double t_new = t_max + step / length;
    const ArcLength along(drawn.curve.polyline);
    Query query;
    query.t = t_new;
    query.drawn = search.drawn_neighborhood(along, along.total() + step);
    query.predecessor = {drawn.curve.polyline.points.back(), drawn.sources.back()};
    query.ends_allowed = false;
    const auto [p, source] = search.choose(query, random, drawn.curve.size());
    drawn.curve.polyline.points.push_back(p);
    drawn.curve.t.push_back(t_new);
    drawn.sources.push_back(source);
    t_max = t_new;
  }
  return drawn;
}

CopiedCurve synthesize_analogy(const Level& level, const SearchParameters& parameters,
                               const RandomStream& random) {
  const Search search(level, parameters);
  const SampledCurve domain = resample(level.sources[0].target, parameters.step * level.spacing,
                                       parameters_of(level.constraints));
  const ArcLength on_target(domain.polyline);
  const double growth = search.filtered().total() / arc_length(level.sources[0].example.polyline);
  CopiedCurve drawn;
  for (std::size_t i = 0; i < domain.size(); ++i) {
    Query query;
    query.t = domain.t[i];
    query.targets = search.target_neighborhoods(query.t);
    query.drawn = Neighborhood(static_cast<std::size_t>(parameters.neighborhood_samples));
    if (i > 0) {
      const ArcLength along(drawn.curve.polyline);
      const double step = on_target.cumulative()[i] - on_target.cumulative()[i - 1];
      query.drawn = search.drawn_neighborhood(along, along.total() + growth * step);
      query.predecessor = {drawn.curve.polyline.points.back(), drawn.sources.back()};
    }
    query.ends_allowed = !domain.polyline.closed &&
                         on_target.total() - on_target.cumulative()[i] < search.half_window();
    const auto [p, source] = search.choose(query, random, i);
    drawn.curve.polyline.points.push_back(p);
    drawn.curve.t.push_back(query.t);
    drawn.sources.push_back(source);
  }
  drawn.curve.polyline.closed = domain.polyline.closed;
  return drawn;
}

CopiedCurve refine_analogy(const Level& level, CopiedCurve initial,
                           const SearchParameters& parameters, const RandomStream& random) {
  const Search search(level, parameters);
  CopiedCurve drawn = std::move(initial);
  const std::size_t points = drawn.curve.size();
  std::vector<std::optional<std::size_t>> sources(drawn.sources.begin(), drawn.sources.end());
  sources.resize(points);
  const bool closed = drawn.curve.polyline.closed;
  for (std::size_t i = 0; i < points; ++i) {
    const ArcLength along(drawn.curve.polyline);
    Query query;
    query.t = drawn.curve.t[i];
    query.targets = search.target_neighborhoods(query.t);
    query.drawn = search.drawn_neighborhood(along, along.cumulative()[i]);
    if (i > 0 || closed) {
      const std::size_t before = i > 0 ? i - 1 : points - 1;
      query.predecessor = {drawn.curve.polyline.points[before], sources[before]};
    }
    const auto [p, source] = search.choose(query, random, i);
    drawn.curve.polyline.points[i] = p;
    sources[i] = source;
  }
  drawn.sources.clear();
  for (const auto& source : sources) drawn.sources.push_back(*source);
  return drawn;
}

CopiedCurve synthesize_curve_multires(const SampledCurve& filtered, double length,
                                      const SearchParameters& parameters) {
  const int levels = *parameters.levels;
  const auto pyramid =
      gaussian_pyramid(filtered, {*parameters.finest_spacing, parameters.level_ratio, levels});
  Level level;
  level.filtered = pyramid[0].curve;
  level.spacing = pyramid[0].spacing;
  set_randomness(level, 0, parameters);
  CopiedCurve drawn =
      synthesize_curve(level, length, parameters, pass_random(parameters.seed, 0, 0, 0));
  drawn = refine_often(level, std::move(drawn), 0, parameters.coarsest_passes, parameters);
  drawn.curve = resample(drawn.curve, 1);
  for (int l = 1; l < levels; ++l) {
    const auto& fine = pyramid[static_cast<std::size_t>(l)];
    const auto& coarse = pyramid[static_cast<std::size_t>(l - 1)];
    level.filtered = fine.curve;
    level.sources = {{coarse.curve, drawn.curve, parameters.coarse_weight}};
    level.spacing = fine.spacing;
    level.offset_weight = parameters.synthesis_offset_weight;
    set_randomness(level, l, parameters);
    drawn = refine_often(level, {resample(drawn.curve, fine.spacing), {}}, l, parameters.passes,
                         parameters);
  }
  return drawn;
}

CopiedCurve synthesize_analogy_multires(const SampledCurve& unfiltered,
                                        const SampledCurve& filtered, const SampledCurve& target,
                                        std::span<const CurveConstraint> constraints,
                                        const SearchParameters& parameters) {
  const int levels = *parameters.levels;
  const GaussianPyramidParams params{*parameters.finest_spacing, parameters.level_ratio, levels};
  const std::vector<double> kept = parameters_of(constraints);
  const auto unfiltered_pyramid = gaussian_pyramid(unfiltered, params);
  const auto filtered_pyramid = gaussian_pyramid(filtered, params);
  const auto target_pyramid = gaussian_pyramid(target, params, kept);
  Level level;
  level.filtered = filtered_pyramid[0].curve;
  level.sources = {{unfiltered_pyramid[0].curve, target_pyramid[0].curve, parameters.shape_weight}};
  level.spacing = filtered_pyramid[0].spacing;
  level.offset_weight = parameters.offset_weight;
  level.constraints = softened(constraints, levels - 1);
  set_randomness(level, 0, parameters);
  CopiedCurve drawn = synthesize_analogy(level, parameters, pass_random(parameters.seed, 0, 0, 0));
  drawn = refine_often(level, std::move(drawn), 0, parameters.coarsest_passes, parameters);
  drawn.curve = resample(drawn.curve, 1, kept);
  for (int l = 1; l < levels; ++l) {
    const auto i = static_cast<std::size_t>(l);
    level.filtered = filtered_pyramid[i].curve;
    level.spacing = filtered_pyramid[i].spacing;
    level.sources = {
        {unfiltered_pyramid[i].curve, target_pyramid[i].curve, parameters.shape_weight},
        {filtered_pyramid[i - 1].curve, drawn.curve, parameters.coarse_weight}};
    level.constraints = softened(constraints, levels - 1 - l);
    set_randomness(level, l, parameters);
    drawn = refine_often(level, {resample(drawn.curve, level.spacing, kept), {}}, l,
                         parameters.passes, parameters);
  }
  return drawn;
}

double curve_cost(const Level& level, const SampledCurve& drawn,
                  const SearchParameters& parameters) {
  Level without_floor = level;
  without_floor.has_floor = false;
  const Search search(without_floor, parameters);
  const ArcLength along(drawn.polyline);
  double sum = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    Query query;
    query.t = drawn.t[i];
    query.targets = search.target_neighborhoods(query.t);
    query.drawn = search.drawn_neighborhood(along, along.cumulative()[i]);
    sum += search.least_cost(query, drawn.polyline.points[i]);
  }
  return sum;
}

}  // namespace libstyle::literal
