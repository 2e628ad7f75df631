// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/synthesis.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libstyle/analogy/feature_size.h"
#include "libstyle/analogy/line_search.h"
#include "libstyle/base/error.h"
#include "libstyle/base/random.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {
namespace {

constexpr double kMostSteps = 1 << 20;

// Found by trial on three coasts, four rivers, loops and waves, 24 seeds each, twice the length of
// the example: median runs of 2 to 9 % of the example, none degenerate, coverage 0.7 to 1, turning
// angles nearer to the example's than its halves are to each other. Larger features leave too few
// states to choose from where a coast has no size of its own; milder factors let rivers walk in a
// circle now and then.
constexpr double kLargestFeature = 0.01;  // of the length of the example
constexpr double kMeanRun = 2;            // feature sizes
constexpr double kLongestRun = 0.12;      // of the example
constexpr double kRepeatFactor = 0.03;    // for each time that a place was used before

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

// The beginning of the curve, up to a length.
void cut(SynthesizedCurve& drawn, double length) {
  const ArcLength along(drawn.curve);
  if (!(along.total() > length)) return;
  const auto [segment, fraction] = along.place_at(length);
  const Point last = along.point_at(length);
  const bool ends_between = last != drawn.curve.points[segment];
  drawn.curve.points.resize(segment + 1);
  if (ends_between) drawn.curve.points.push_back(last);
  for (std::vector<double>& values : drawn.features) {
    const double end = std::lerp(values[segment], values[segment + 1], fraction);
    values.resize(segment + 1);
    if (ends_between) values.push_back(end);
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
      jumps_(make_jump_model(example_, parameters_.mean_run.value_or(kMeanRun), false)) {
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

SynthesizedCurve CurveSynthesis::draw(double length, std::uint64_t place,
                                      std::uint64_t variant) const {
  if (!(length > 0 && length <= longest_curve())) {
    throw Error("the length of a curve to be made must be above 0 px and at most " +
                std::to_string(static_cast<long long>(longest_curve())) + " px");
  }
  if (!search_) return walk(length, place, variant);
  const SearchedCurve drawn = search_->synthesize(length, {}, place, variant);
  SynthesizedCurve result{drawn.curve.polyline, copied_features(example_, drawn, 1),
                          find_runs(example_, drawn)};
  const Point start = result.curve.points.front();
  for (Point& p : result.curve.points) p -= start;
  return result;
}

SynthesizedCurve CurveSynthesis::walk(double length, std::uint64_t place,
                                      std::uint64_t variant) const {
  ChainTask task;
  task.steps = static_cast<std::size_t>(std::ceil(kSpareSteps * length / example_.step())) + 1;
  const std::vector<ChainState> walk = sample_chain(
      jumps_.chain, task, RandomStream(parameters_.seed + variant, place), 0, variety());

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
  cut(result, length);
  return result;
}

}  // namespace libstyle
