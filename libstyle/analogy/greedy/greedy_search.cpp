// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/greedy_search.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include "libstyle/analogy/greedy/detail_transfer.h"
#include "libstyle/analogy/greedy/level_example.h"
#include "libstyle/analogy/greedy/level_search.h"
#include "libstyle/analogy/greedy/softened_weight.h"
#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/gaussian.h"
#include "libstyle/geometry/gaussian_pyramid.h"

namespace libstyle {
namespace {

// The paper resamples the coarsest curve "at unit arc length intervals".
constexpr double kCoarsestResampling = 1;

SampledCurve scaled(SampledCurve curve, double factor) {
  for (Point& p : curve.polyline.points) p *= factor;
  return curve;
}

// Sound for a search: finite, of different points, and of a length.
SampledCurve checked(const SampledCurve& curve, const char* what) {
  if (curve.size() != curve.t.size()) {
    throw Error(std::string(what) + " has not one parameter for each point");
  }
  for (const Point p : curve.polyline.points) {
    if (!is_finite(p)) throw Error(std::string(what) + " has a coordinate that is not finite");
  }
  SampledCurve clean{curve.polyline, curve.t, {}};
  if (clean.size() > 0) clean = without_repeated_points(clean);
  if (clean.size() < 2) {
    throw Error(std::string(what) + " has no length: give it two different points");
  }
  return clean;
}

std::vector<double> parameters_of(std::span<const CurveConstraint> constraints) {
  std::vector<double> result;
  for (const CurveConstraint& constraint : constraints) result.push_back(constraint.t);
  return result;
}

}  // namespace

class GreedySearch::Implementation {
 public:
  Implementation(std::span<const SearchExample> examples, const SearchParameters& parameters);

  SearchedCurve draw(const SampledCurve& target, std::span<const CurveConstraint> constraints,
                     std::uint64_t place, std::uint64_t variant) const;
  SearchedCurve synthesize(double length, std::span<const CurveConstraint> constraints,
                           std::uint64_t place, std::uint64_t variant) const;
  double finest_spacing() const { return finest_spacing_; }
  int levels() const { return levels_; }

 private:
  using Pyramid = std::vector<GaussianPyramidLevel>;

  // One curve to be made; the target's pyramid is empty in synthesis.
  struct Run {
    Pyramid target;
    std::vector<CurveConstraint> given, constraints;  // in px and in internal units
    std::uint64_t place = 0;
    std::uint64_t seed = 0;
    double length = 0;  // of the curve to be
  };

  double unit() const { return kFinestSpacing / finest_spacing_; }  // internal, for a px
  Pyramid pyramid(const SampledCurve& curve, std::span<const double> kept = {}) const;
  void set_scale(std::span<const SearchExample> examples);
  int count_levels(std::span<const SearchExample> examples, double samples) const;
  void prepare_levels(std::span<const SearchExample> examples);
  Run begin(std::span<const CurveConstraint> constraints, std::uint64_t place) const;
  LevelTask task(const Run& run, int level) const;
  DrawnLevel search(const Run& run) const;
  DrawnLevel grow(LevelSearch& search, const Run& run) const;
  DrawnLevel next_level(const DrawnLevel& drawn, const SampledCurve& coarse, const Run& run,
                        int level) const;
  void refine(LevelSearch& search, DrawnLevel& drawn, const Run& run, int level, int passes) const;
  SearchedCurve finish(const DrawnLevel& drawn, const Run& run) const;

  SearchParameters parameters_;
  bool analogy_ = false;
  double finest_spacing_ = 0;
  int levels_ = 0;
  std::deque<LevelExample> examples_;  // coarsest first
};

// ---- The example --------------------------------------------------------------------------------

GreedySearch::Implementation::Implementation(std::span<const SearchExample> examples,
                                             const SearchParameters& parameters)
    : parameters_((validate(parameters), parameters)) {
  if (examples.empty()) throw Error("there is no example to search");
  analogy_ = examples[0].unfiltered.has_value();
  for (const SearchExample& example : examples) {
    if (example.unfiltered.has_value() != analogy_) {
      throw Error("some examples have unfiltered curves and some have none");
    }
  }
  set_scale(examples);
  prepare_levels(examples);
}

void GreedySearch::Implementation::set_scale(std::span<const SearchExample> examples) {
  double length = 0;
  for (const SearchExample& example : examples) {
    length += arc_length(checked(example.filtered, "the filtered example").polyline);
  }
  finest_spacing_ = parameters_.finest_spacing.value_or(length / parameters_.samples);
  const double samples = length / finest_spacing_;
  if (!(samples <= 1e6)) throw Error("the finest spacing is too small for the example");
  levels_ = parameters_.levels.value_or(1);
  if (!parameters_.levels) levels_ = count_levels(examples, samples);
}

// Blurring shortens curves, so how long one is at a level has to be tried: loops are gone soon.
int GreedySearch::Implementation::count_levels(std::span<const SearchExample> examples,
                                               double samples) const {
  const double ratio = parameters_.level_ratio;
  const double most = std::log(samples / parameters_.coarsest_samples) / std::log(ratio);
  std::vector<SampledCurve> curves;
  for (const SearchExample& example : examples) curves.push_back(scaled(example.filtered, unit()));
  int above = static_cast<int>(std::clamp(std::round(most), 0.0, 63.0));
  for (; above > 0; --above) {
    const double scale = std::pow(ratio, above);
    double total = 0, shortest = std::numeric_limits<double>::infinity();
    for (const SampledCurve& curve : curves) {
      const double length = arc_length(gaussian_blur(curve.polyline, kFinestSpacing * scale));
      total += length;
      shortest = std::min(shortest, length);
    }
    const double spacing = kFinestSpacing * scale;
    if (total >= parameters_.coarsest_samples * spacing &&
        shortest >= LevelExample::shortest_curve(spacing, parameters_)) {
      break;
    }
  }
  return above + 1;
}

GreedySearch::Implementation::Pyramid GreedySearch::Implementation::pyramid(
    const SampledCurve& curve, std::span<const double> kept) const {
  return gaussian_pyramid(scaled(curve, unit()), {kFinestSpacing, parameters_.level_ratio, levels_},
                          kept);
}

void GreedySearch::Implementation::prepare_levels(std::span<const SearchExample> examples) {
  std::vector<Pyramid> unfiltered, filtered;
  for (const SearchExample& example : examples) {
    filtered.push_back(pyramid(checked(example.filtered, "the filtered example")));
    if (!analogy_) continue;
    unfiltered.push_back(pyramid(checked(*example.unfiltered, "the unfiltered example")));
  }
  for (std::size_t l = 0; l < static_cast<std::size_t>(levels_); ++l) {
    std::vector<ExampleCurves> curves;
    for (std::size_t i = 0; i < examples.size(); ++i) {
      curves.push_back({filtered[i][l].curve, {}});
      if (analogy_) curves.back().sources.push_back(unfiltered[i][l].curve);
      if (l > 0) curves.back().sources.push_back(filtered[i][l - 1].curve);
    }
    std::vector<double> weights;
    if (analogy_) weights.push_back(parameters_.shape_weight);
    if (l > 0) weights.push_back(parameters_.coarse_weight);
    const bool has_floor = static_cast<int>(l) < parameters_.random_levels;
    examples_.emplace_back(std::move(curves), std::move(weights), filtered[0][l].spacing, has_floor,
                           parameters_);
  }
}

// ---- A run --------------------------------------------------------------------------------------

GreedySearch::Implementation::Run GreedySearch::Implementation::begin(
    std::span<const CurveConstraint> constraints, std::uint64_t place) const {
  Run run;
  run.place = place;
  run.seed = parameters_.seed;
  run.given = checked_constraints(constraints);
  run.constraints = run.given;
  for (CurveConstraint& constraint : run.constraints) {
    constraint.position *= unit();
    if (constraint.weight) *constraint.weight /= unit() * unit();
  }
  return run;
}

SearchedCurve GreedySearch::Implementation::draw(const SampledCurve& target,
                                                 std::span<const CurveConstraint> constraints,
                                                 std::uint64_t place, std::uint64_t variant) const {
  if (!analogy_) throw Error("the examples have no unfiltered curves; they serve for synthesis");
  Run run = begin(constraints, place);
  run.seed += variant;
  run.target = pyramid(checked(target, "a curve to be drawn"), parameters_of(run.constraints));
  run.length = arc_length(run.target.back().curve.polyline) * examples_.back().growth();
  return finish(search(run), run);
}

SearchedCurve GreedySearch::Implementation::synthesize(double length,
                                                       std::span<const CurveConstraint> constraints,
                                                       std::uint64_t place,
                                                       std::uint64_t variant) const {
  if (analogy_) throw Error("the examples have unfiltered curves; synthesis wants none");
  if (!(length > 0) || !std::isfinite(length)) {
    throw Error("the length of a curve to be made must be a positive number");
  }
  Run run = begin(constraints, place);
  run.seed += variant;
  run.length = length * unit();
  if (run.length / kFinestSpacing > 1e7) throw Error("the curve to be made is too long");
  return finish(search(run), run);
}

LevelTask GreedySearch::Implementation::task(const Run& run, int level) const {
  LevelTask task;
  if (analogy_) task.targets.push_back(run.target[static_cast<std::size_t>(level)].curve);
  task.offset_weight = analogy_ ? parameters_.offset_weight : parameters_.synthesis_offset_weight;
  task.epsilon = level < parameters_.random_levels ? parameters_.epsilon : parameters_.fine_epsilon;
  task.constraints = run.constraints;
  for (CurveConstraint& constraint : task.constraints) {
    constraint.weight = softened_weight(constraint.weight, levels_ - 1 - level);
  }
  return task;
}

DrawnLevel GreedySearch::Implementation::search(const Run& run) const {
  DrawnLevel drawn;
  SampledCurve coarse;  // B'_(l-1)
  for (int level = 0; level < levels_; ++level) {
    LevelTask level_task = task(run, level);
    if (level > 0) {
      DrawnLevel next = next_level(drawn, coarse, run, level);
      level_task.targets.push_back(std::move(coarse));
      drawn = std::move(next);
    }
    LevelSearch search(examples_[static_cast<std::size_t>(level)], std::move(level_task),
                       parameters_);
    if (level == 0) drawn = grow(search, run);
    refine(search, drawn, run, level,
           level == 0 ? parameters_.coarsest_passes : parameters_.passes);
    coarse = drawn.curve;
    if (level == 0 && !parameters_.detail_transfer) {
      coarse = resample(coarse, kCoarsestResampling, parameters_of(run.constraints));
    }
  }
  return drawn;
}

DrawnLevel GreedySearch::Implementation::grow(LevelSearch& search, const Run& run) const {
  const RandomStream random = pass_random(run.seed, run.place, 0, 0);
  if (analogy_) return search.grow_along_target(random);
  // Detail adds to the length of what is grown now as much as it does in the example.
  const double share =
      parameters_.detail_transfer ? examples_[0].length() / examples_.back().length() : 1;
  return search.grow_freely(run.length * share, random);
}

DrawnLevel GreedySearch::Implementation::next_level(const DrawnLevel& drawn,
                                                    const SampledCurve& coarse, const Run& run,
                                                    int level) const {
  const std::vector<double> kept = parameters_of(run.constraints);
  const LevelExample& fine = examples_[static_cast<std::size_t>(level)];
  if (parameters_.detail_transfer) {
    return transfer_detail(examples_[static_cast<std::size_t>(level - 1)], fine, drawn, kept);
  }
  DrawnLevel next;
  next.curve = resample(coarse, fine.spacing(), kept);
  next.sources.assign(next.curve.size(), kNoPlace);
  next.rotations.assign(next.curve.size(), Vector{1, 0});
  return next;
}

void GreedySearch::Implementation::refine(LevelSearch& search, DrawnLevel& drawn, const Run& run,
                                          int level, int passes) const {
  for (int pass = 1; pass <= passes; ++pass) {
    const bool backward = parameters_.alternate_passes && pass % 2 == 0;
    search.refine(drawn, backward, pass_random(run.seed, run.place, level, pass));
    const double length = arc_length(drawn.curve.polyline);
    if (!(length <= parameters_.longest_growth * run.length)) {
      throw Error(
          "the drawn curve grows without bound: lower offset_weight, or let "
          "neighborhoods reach farther");
    }
  }
}

SearchedCurve GreedySearch::Implementation::finish(const DrawnLevel& drawn, const Run& run) const {
  SearchedCurve result;
  result.curve = scaled(drawn.curve, 1 / unit());
  for (const CurveConstraint& constraint : run.given) {
    const auto at = std::ranges::lower_bound(result.curve.t, constraint.t);
    // Scaling rounds; a hard constraint is exact.
    if (!constraint.weight && at != result.curve.t.end() && *at == constraint.t) {
      result.curve.polyline.points[static_cast<std::size_t>(at - result.curve.t.begin())] =
          constraint.position;
    }
  }
  const LevelExample& finest = examples_.back();
  for (std::size_t i = 0; i < drawn.sources.size(); ++i) {
    const std::size_t j = drawn.sources[i];
    const std::vector<Point>& points = drawn.curve.polyline.points;
    const bool continues =
        i > 0 && finest.copied_length(drawn.sources[i - 1], j, distance(points[i - 1], points[i]));
    result.sources.push_back(
        {finest.curve_of(j), finest.length_of(j) / unit(), finest.parameter_of(j), continues});
  }
  return result;
}

// ---- The interface ------------------------------------------------------------------------------

GreedySearch::GreedySearch(std::span<const SearchExample> examples,
                           const SearchParameters& parameters)
    : implementation_(std::make_unique<const Implementation>(examples, parameters)) {}
GreedySearch::~GreedySearch() = default;
GreedySearch::GreedySearch(GreedySearch&&) noexcept = default;
GreedySearch& GreedySearch::operator=(GreedySearch&&) noexcept = default;

SearchedCurve GreedySearch::draw(const SampledCurve& target,
                                 std::span<const CurveConstraint> constraints, std::uint64_t place,
                                 std::uint64_t variant) const {
  return implementation_->draw(target, constraints, place, variant);
}

SearchedCurve GreedySearch::synthesize(double length, std::span<const CurveConstraint> constraints,
                                       std::uint64_t place, std::uint64_t variant) const {
  return implementation_->synthesize(length, constraints, place, variant);
}

double GreedySearch::finest_spacing() const { return implementation_->finest_spacing(); }
int GreedySearch::levels() const { return implementation_->levels(); }

}  // namespace libstyle
