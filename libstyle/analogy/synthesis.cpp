// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/synthesis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "libstyle/analogy/feature_size.h"
#include "libstyle/analogy/line_search.h"
#include "libstyle/analogy/soft_constraints.h"
#include "libstyle/analogy/walk_aim.h"
#include "libstyle/analogy/warp.h"
#include "libstyle/base/error.h"
#include "libstyle/base/number.h"
#include "libstyle/base/random.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/rigid_alignment.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {
namespace {

constexpr double kMostSteps = 1 << 20;

// Found by trial on three coasts, four rivers, loops, waves, zigzags and grass, 20 seeds each,
// twice the length of the example: median runs of 1 to 7 % of the example, none degenerate,
// coverage 0.77 to 1, turning angles nearer to the example's than its halves are to each other.
// Larger features leave too few states to choose from where a coast has no size of its own; milder
// factors let rivers walk in a circle now and then. With the freedom that analogies have, a river
// that turns once never comes back from the part where it began (coverage 0.33).
constexpr double kLargestFeature = 0.01;  // of the length of the example
constexpr double kMeanRun = 2;            // feature sizes
constexpr double kLongestRun = 0.12;      // of the example
constexpr double kRepeatFactor = 0.03;    // for each time that a place was used before
constexpr double kFreedom = 6;            // times the tolerance of the example

// More steps than the length needs: where two runs fade into each other their moves may differ in
// direction, and the curve gets shorter by as much.
constexpr double kSpareSteps = 1.15;

// The example as its own line, along which it has no offsets: what is left to compare is tangents.
std::vector<ExamplePair> own_lines(std::vector<ExamplePair> pairs) {
  for (ExamplePair& pair : pairs) {
    pair.unfiltered = with_length_parameter(pair.filtered.polyline);
    pair.filtered.t = pair.unfiltered->t;
    pair.same_parameter = true;
    pair.others.clear();
  }
  return pairs;
}

std::vector<ExamplePair> pairs_of(std::span<const Polyline> examples) {
  std::vector<ExamplePair> pairs;
  for (const Polyline& example : examples) {
    pairs.push_back({std::nullopt, with_length_parameter(example)});
  }
  return pairs;
}

CurveAnalogyParameters synthesis_parameters(std::span<const ExamplePair> examples,
                                            CurveAnalogyParameters parameters) {
  validate(parameters);
  parameters.smoothing = 0;
  std::vector<Polyline> curves;
  double length = 0;
  for (const ExamplePair& example : examples) {
    curves.push_back(example.filtered.polyline);
    length += arc_length(curves.back());
  }
  // Curves that cannot serve are refused by Example.
  if (!parameters.feature_size && length > 0 && std::isfinite(length)) {
    parameters.feature_size =
        std::min(find_feature_size(curves, std::nullopt), kLargestFeature * length);
  }
  return parameters;
}

// The direction that each run is turned to: the first as it was drawn, the others on from the one
// before.
std::vector<Vector> turns(const PlacedRuns& runs) {
  std::vector<Vector> result = {{1, 0}};
  for (std::size_t i = 1; i < runs.runs().size(); ++i) {
    const PlacedRuns::Placed &before = runs.runs()[i - 1], &run = runs.runs()[i];
    const Vector arriving =
        to_page(before.line->sweep().frame_at(runs.length_at(before, before.end)), result.back());
    const Vector leaving = run.line->sweep().frame_at(run.length);
    result.push_back(normalized(to_frame(arriving, leaving)));
  }
  return result;
}

// How the curve moves between two coordinates.
class Moves {
 public:
  explicit Moves(const PlacedRuns& runs) : runs_(runs), turns_(turns(runs)) {}

  Vector between(double from, double to) const {
    const PlacedRuns::Blend blend = runs_.blend_at((from + to) / 2);
    const Vector left = move(blend.left, from, to);
    if (blend.left == blend.right) return left;
    return lerp(left, move(blend.right, from, to), blend.right_share);
  }

 private:
  Vector move(std::size_t index, double from, double to) const {
    const PlacedRuns::Placed& run = runs_.runs()[index];
    const Point a = run.line->filtered_at(runs_.length_at(run, from));
    const Point b = run.line->filtered_at(runs_.length_at(run, to));
    return to_page(b - a, turns_[index]);
  }

  const PlacedRuns& runs_;
  std::vector<Vector> turns_;
};

void append_features(SynthesizedCurve& drawn, const std::vector<double>& values) {
  drawn.features.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) drawn.features[i].push_back(values[i]);
}

std::vector<SearchExample> search_examples(const Example& example) {
  std::vector<SearchExample> result;
  for (const Polyline& curve : filtered_curves(example)) {
    result.push_back({std::nullopt, with_length_parameter(curve)});
  }
  return result;
}

double value_at(std::span<const double> values, const PolylinePlace& place) {
  return std::lerp(values[place.segment], values[place.segment + 1], place.fraction);
}

// The beginning of the curve, up to a length.
void cut(SynthesizedCurve& drawn, double length) {
  const ArcLength along(drawn.curve);
  if (!(along.total() > length)) return;
  const PolylinePlace place = along.place_at(length);
  const Point last = along.point_at(length);
  const bool ends_between = last != drawn.curve.points[place.segment];
  drawn.curve.points.resize(place.segment + 1);
  if (ends_between) drawn.curve.points.push_back(last);
  for (std::vector<double>& values : drawn.features) {
    const double end = value_at(values, place);
    values.resize(place.segment + 1);
    if (ends_between) values.push_back(end);
  }
}

// ---- Constraints --------------------------------------------------------------------------------

constexpr double kSameShare = 1e-9;   // constraints nearer to each other than that are on one place
constexpr std::uint64_t kTries = 16;  // walks that are drawn
constexpr double kUnbent = 1e6;       // lengths of the curve: the bends between constraints only

// A line cannot get farther than it is long.
void refuse_distant(std::span<const CurveConstraint> constraints, double length) {
  const CurveConstraint* last = nullptr;
  for (const CurveConstraint& constraint : constraints) {
    if (constraint.weight) continue;
    if (last) {
      const double apart = distance(last->position, constraint.position);
      const double between = (constraint.t - last->t) * length;
      if (apart > between * (1 + kSameShare)) {
        std::string message = "two places to pass are ";
        append_number(message, std::round(10 * apart) / 10);
        message += " px apart, and only ";
        append_number(message, std::round(10 * between) / 10);
        message += " px of the line lie between them; make it longer";
        throw Error(message);
      }
    }
    last = &constraint;
  }
}

std::vector<Vector> moves_between(const Polyline& curve, std::span<const CurveConstraint> pins) {
  const ArcLength along(curve);
  std::vector<Vector> moves;
  for (std::size_t i = 0; i + 1 < pins.size(); ++i) {
    moves.push_back(along.point_at(pins[i + 1].t * along.total()) -
                    along.point_at(pins[i].t * along.total()));
  }
  return moves;
}

// Gives the curve points at these lengths along it, rising.
void add_points(SynthesizedCurve& drawn, const ArcLength& along, std::span<const double> lengths) {
  std::vector<Point> points;
  std::vector<std::vector<double>> features(drawn.features.size());
  auto next = lengths.begin();
  const std::span<const double> own = along.cumulative();
  for (std::size_t i = 0; i < own.size(); ++i) {
    for (; next != lengths.end() && *next <= own[i]; ++next) {
      if (*next == own[i]) continue;
      points.push_back(along.point_at(*next));
      const PolylinePlace place = along.place_at(*next);
      for (std::size_t f = 0; f < features.size(); ++f) {
        features[f].push_back(value_at(drawn.features[f], place));
      }
    }
    points.push_back(drawn.curve.points[i]);
    for (std::size_t f = 0; f < features.size(); ++f) features[f].push_back(drawn.features[f][i]);
  }
  drawn.curve.points = std::move(points);
  drawn.features = std::move(features);
}

void bend_through(SynthesizedCurve& drawn, std::span<const CurveConstraint> pins) {
  if (pins.empty()) return;
  drawn.is_placed = true;
  std::vector<double> lengths;
  std::vector<WarpTarget> targets;
  const ArcLength before(drawn.curve);
  for (const CurveConstraint& pin : pins) {
    lengths.push_back(pin.t * before.total());
    targets.push_back({lengths.back(), pin.position - before.point_at(lengths.back())});
  }
  add_points(drawn, before, lengths);
  const std::vector<double> along = cumulative_lengths(drawn.curve);
  const Warp warp(targets, kUnbent * before.total());
  for (std::size_t i = 0; i < along.size(); ++i) drawn.curve.points[i] += warp.at(along[i]);
  for (std::size_t k = 0; k < pins.size(); ++k) {
    const auto after = std::ranges::lower_bound(along, lengths[k]);
    auto i = static_cast<std::size_t>(after - along.begin());
    // Lengths are summed anew and may differ in the last digit.
    if (i == along.size() || (i > 0 && lengths[k] - along[i - 1] < along[i] - lengths[k])) --i;
    drawn.curve.points[i] = pins[k].position;
    drawn.pinned.push_back(i);
  }
}

}  // namespace

CurveSynthesis::CurveSynthesis(std::span<const Polyline> examples,
                               const CurveAnalogyParameters& parameters)
    : CurveSynthesis(pairs_of(examples), parameters) {}

CurveSynthesis::CurveSynthesis(std::span<const ExamplePair> examples,
                               const CurveAnalogyParameters& parameters)
    : asked_(parameters),
      parameters_(synthesis_parameters(examples, parameters)),
      example_(own_lines({examples.begin(), examples.end()}), parameters_),
      jumps_(make_jump_model(
          example_, {.mean_run = parameters_.mean_run.value_or(kMeanRun), .freedom = kFreedom})) {
  if (parameters_.method == AnalogyMethod::kGreedy) {
    search_.emplace(search_examples(example_), search_parameters(parameters_));
  }
}

double CurveSynthesis::longest_curve() const {
  const double longest = kMostSteps * example_.step();
  return search_ ? std::min(longest, libstyle::longest_curve(*search_)) : longest;
}

StyleSummary CurveSynthesis::summary() const {
  StyleSummary summary = summarize(example_, jumps_, asked_,
                                   parameters_.mean_run.value_or(kMeanRun), variety().longest_run);
  if (search_) summary.search = summarize(*search_, search_parameters(parameters_));
  return summary;
}

ChainVariety CurveSynthesis::variety() const {
  const double longest = kLongestRun * static_cast<double>(example_.state_count());
  return {static_cast<std::size_t>(longest) + 1, kRepeatFactor};
}

// What is asked for.
struct CurveSynthesis::Task {
  double length = 0;
  RandomStream random;
};

SynthesizedCurve CurveSynthesis::draw(double length, std::uint64_t place, std::uint64_t variant,
                                      std::span<const CurveConstraint> constraints) const {
  if (!(length > 0 && length <= longest_curve())) {
    throw Error("the length of a curve to be made must be above 0 px and at most " +
                std::to_string(static_cast<long long>(longest_curve())) + " px");
  }
  if (search_) return search(length, place, variant, constraints);
  const Task task{length, RandomStream(parameters_.seed + variant, place)};
  if (constraints.empty()) return walk(task, 0, {});
  const std::vector<CurveConstraint> distinct =
      distinct_constraints(checked_constraints(constraints), kSameShare);
  refuse_distant(distinct, length);
  return draw_through(task, settled(task, distinct));
}

SynthesizedCurve CurveSynthesis::search(double length, std::uint64_t place, std::uint64_t variant,
                                        std::span<const CurveConstraint> constraints) const {
  refuse_distant(checked_constraints(constraints), length);
  const SearchedCurve drawn = search_->synthesize(length, constraints, place, variant);
  SynthesizedCurve result{drawn.curve.polyline, copied_features(example_, drawn, 1),
                          find_runs(example_, drawn)};
  result.is_placed = !constraints.empty();
  for (const CurveConstraint& constraint : checked_constraints(constraints)) {
    if (constraint.weight) continue;
    const auto at = std::ranges::lower_bound(drawn.curve.t, constraint.t);
    result.pinned.push_back(static_cast<std::size_t>(at - drawn.curve.t.begin()));
  }
  if (result.is_placed) return result;
  const Point start = result.curve.points.front();
  for (Point& p : result.curve.points) p -= start;
  return result;
}

SynthesizedCurve CurveSynthesis::walk(const Task& asked, std::uint64_t first_place,
                                      const StepCosts& costs) const {
  ChainTask task;
  task.steps =
      static_cast<std::size_t>(std::ceil(kSpareSteps * asked.length / example_.step())) + 1;
  task.costs = costs;
  const std::vector<ChainState> walk =
      sample_chain(jumps_.chain, task, asked.random, first_place, variety());

  SynthesizedCurve result;
  result.runs = find_runs(example_, walk);
  const PlacedRuns runs(example_, result.runs, task.steps, false);
  std::vector<double> xs = runs.sample_coordinates(static_cast<double>(task.steps));
  xs.push_back(static_cast<double>(task.steps));
  const Moves moves(runs);
  Point at;
  result.curve.points = {at};
  append_features(result, runs.features_at(runs.blend_at(0), 0));
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    at += moves.between(xs[i], xs[i + 1]);
    if (at == result.curve.points.back()) continue;
    result.curve.points.push_back(at);
    append_features(result, runs.features_at(runs.blend_at(xs[i + 1]), xs[i + 1]));
  }
  cut(result, asked.length);
  return result;
}

// ---- Constraints --------------------------------------------------------------------------------

// Soft constraints as hard ones. A free curve strays like a random walk of steps of one feature
// size; with nothing to hold on to, it is first put where it fits best.
std::vector<CurveConstraint> CurveSynthesis::settled(
    const Task& task, std::vector<CurveConstraint> constraints) const {
  std::vector<CurveConstraint> hard;
  for (const CurveConstraint& constraint : constraints) {
    if (!constraint.weight) hard.push_back(constraint);
  }
  if (hard.size() == constraints.size()) return constraints;

  SynthesizedCurve drawn = draw_through(task, hard);
  if (hard.empty()) put_in_place(drawn, constraints);
  const ArcLength along(drawn.curve);
  std::vector<Pull> pulls;
  for (const CurveConstraint& c : constraints) {
    Pull pull{c.t * task.length, {}, c.weight};
    if (c.weight) pull.offset = c.position - along.point_at(c.t * along.total());
    pulls.push_back(pull);
  }
  const double deviation = std::sqrt(example_.feature_size() * task.length);
  const std::vector<Vector> offsets = yielding_offsets(pulls, {deviation, 2 * task.length});
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    if (!constraints[i].weight) continue;
    constraints[i].position += offsets[i] - pulls[i].offset;
    constraints[i].weight.reset();
  }
  return constraints;
}

// Of several walks the one that has to be bent least.
SynthesizedCurve CurveSynthesis::draw_through(const Task& task,
                                              std::span<const CurveConstraint> pins) const {
  std::vector<WalkAim::Stretch> stretches;
  for (std::size_t i = 0; i + 1 < pins.size(); ++i) {
    const double steps = task.length / example_.step();
    stretches.push_back(
        {pins[i].t * steps, pins[i + 1].t * steps, pins[i + 1].position - pins[i].position});
  }
  const bool aimed = parameters_.invariance == Invariance::kTranslate;
  WalkAim aim(example_, stretches);
  SynthesizedCurve best;
  double least = std::numeric_limits<double>::infinity();
  const std::uint64_t tries = pins.size() > 1 ? kTries : 1;
  for (std::uint64_t i = 0; i < tries; ++i) {
    SynthesizedCurve drawn = walk(
        task, i << 32, [&](std::size_t step, auto costs) { return aimed && aim.add(step, costs); });
    put_in_place(drawn, pins);
    const std::vector<Vector> moves = moves_between(drawn.curve, pins);
    double bend = 0;
    for (std::size_t k = 0; k < moves.size(); ++k) {
      const double share = pins[k + 1].t - pins[k].t;
      bend += squared_norm(stretches[k].move - moves[k]) / share;
    }
    aim.correct(moves);
    if (bend < least) {
      least = bend;
      best = std::move(drawn);
    }
  }
  bend_through(best, pins);
  return best;
}

// Pieces that keep their direction are only moved.
void CurveSynthesis::put_in_place(SynthesizedCurve& drawn,
                                  std::span<const CurveConstraint> constraints) const {
  if (constraints.empty()) return;
  const ArcLength along(drawn.curve);
  std::vector<Point> places, wanted;
  std::vector<double> weights;
  for (const CurveConstraint& constraint : constraints) {
    places.push_back(along.point_at(constraint.t * along.total()));
    wanted.push_back(constraint.position);
    weights.push_back(constraint.weight.value_or(1));
  }
  const RigidTransform move = (parameters_.invariance == Invariance::kRotate
                                   ? align_rigidly(places, wanted, weights)
                                   : align_by_translation(places, wanted, weights))
                                  .target_from_source;
  for (Point& p : drawn.curve.points) p = move(p);
}

}  // namespace libstyle
