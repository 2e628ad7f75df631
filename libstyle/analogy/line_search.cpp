// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/line_search.h"

#include <algorithm>
#include <cmath>

#include "libstyle/geometry/arc_length.h"

namespace libstyle {
namespace {

constexpr double kAllButAnEnd = 1e-9;  // of the length
constexpr double kMostSpacings = 1 << 16;

// Both curves as functions of the length along the unfiltered one.
SearchExample search_example(const ExampleLine& line) {
  SampledCurve unfiltered, filtered;
  for (const ExampleLine::Sample& sample : line.samples()) {
    const Point place = line.sweep().point_at(sample.length);
    const double t = sample.length / line.length();
    unfiltered.polyline.points.push_back(place);
    unfiltered.t.push_back(t);
    filtered.polyline.points.push_back(
        line.sweep().point_at(sample.length, sample.blur) +
        to_page(sample.offset, line.sweep().frame_at(sample.length)));
    filtered.t.push_back(t);
  }
  return {unfiltered, filtered};
}

std::vector<SearchExample> search_examples(const Example& example) {
  std::vector<SearchExample> result;
  for (const ExampleLine& line : example.lines()) result.push_back(search_example(line));
  return result;
}

SampledCurve scaled(SampledCurve curve, double factor) {
  for (Point& p : curve.polyline.points) p *= factor;
  return curve;
}

// What all but is an end is the end.
std::vector<CurveConstraint> curve_constraints(const ArcLength& along,
                                               std::span<const LineConstraint> constraints) {
  std::vector<CurveConstraint> result;
  for (const LineConstraint& constraint : constraints) {
    double t = constraint.length / along.total();
    if (t < kAllButAnEnd) t = 0;
    if (t > 1 - kAllButAnEnd) t = along.polyline().closed ? 0 : 1;
    const Point own = along.point_at(t == 0 ? 0 : t == 1 ? along.total() : constraint.length);
    result.push_back({t, constraint.position.value_or(own), constraint.weight});
  }
  return result;
}

// Which state of an example a vertex was copied from.
class StatesByPlace {
 public:
  explicit StatesByPlace(const Example& example) : example_(example) {
    for (std::size_t j = 0; j < example.state_count(); ++j) {
      if (j == 0 || example.line_of(j) != example.line_of(j - 1)) first_states_.push_back(j);
    }
  }

  ChainState at(const SearchedCurve::Source& source) const {
    const double steps = source.t * example_.lines()[source.example].length() / example_.step();
    const std::size_t first = first_states_[source.example];
    const std::size_t end = source.example + 1 < first_states_.size()
                                ? first_states_[source.example + 1]
                                : example_.state_count();
    return static_cast<ChainState>(
        std::min(first + static_cast<std::size_t>(std::max(0.0, steps)), end - 1));
  }

 private:
  const Example& example_;
  std::vector<std::size_t> first_states_;  // of each line of the example
};

}  // namespace

SearchParameters search_parameters(const CurveAnalogyParameters& parameters) {
  SearchParameters search = parameters.search;
  search.seed = parameters.seed;
  search.rotate = parameters.invariance == Invariance::kRotate;
  search.shape_weight = parameters.shape_weight;
  search.samples = parameters.samples;
  return search;
}

std::vector<ChainRun> find_runs(const Example& example, const SearchedCurve& drawn) {
  const StatesByPlace states(example);
  std::vector<ChainRun> runs;
  std::size_t steps = 0;
  for (const SearchedCurve::Source& source : drawn.sources) {
    const ChainState state = states.at(source);
    const bool goes_on = !runs.empty() && source.continues;
    if (!goes_on) runs.push_back({steps, 0, state});
    const ChainState next = runs.back().origin + static_cast<ChainState>(runs.back().steps);
    // A step of the line for every step that the piece takes on the example.
    const std::size_t more = state >= next ? state - next + 1 : (goes_on ? 0 : 1);
    runs.back().steps += more;
    steps += more;
  }
  return runs;
}

std::vector<std::vector<double>> copied_features(const Example& example, const SearchedCurve& drawn,
                                                 double scale) {
  const std::span<const LineFeature> features = example.features();
  std::vector<std::vector<double>> result(features.size());
  for (const SearchedCurve::Source& source : drawn.sources) {
    const ExampleLine& line = example.lines()[source.example];
    const std::vector<double> values = line.lane(0).features_at(source.t * line.length());
    for (std::size_t i = 0; i < features.size(); ++i) {
      const bool is_length = features[i].kind == FeatureKind::kLength;
      result[i].push_back(is_length ? scale * values[i] : values[i]);
    }
  }
  return result;
}

double longest_curve(const GreedySearch& search) { return kMostSpacings * search.finest_spacing(); }

StyleSummary::Search summarize(const GreedySearch& search, const SearchParameters& parameters) {
  return {parameters, search.finest_spacing(), search.levels()};
}

LineSearch::LineSearch(const Example& example, const CurveAnalogyParameters& parameters)
    : example_(example),
      parameters_(search_parameters(parameters)),
      search_(search_examples(example), parameters_) {}

LineSearch::Result LineSearch::draw(const Polyline& line, double scale,
                                    std::span<const LineConstraint> constraints,
                                    std::uint64_t place, std::uint64_t variant) const {
  const ArcLength along(line);
  const std::vector<CurveConstraint> given = curve_constraints(along, constraints);
  std::vector<CurveConstraint> to_scale = given;
  for (CurveConstraint& constraint : to_scale) {
    constraint.position *= 1 / scale;
    if (constraint.weight) *constraint.weight *= scale * scale;
  }
  const SearchedCurve drawn =
      search_.draw(scaled(with_length_parameter(line), 1 / scale), to_scale, place, variant);

  Result result{{scaled(drawn.curve, scale).polyline, {}, copied_features(example_, drawn, scale)},
                find_runs(example_, drawn)};
  for (const double t : drawn.curve.t) result.line.lengths.push_back(t * along.total());
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i].weight) continue;
    const auto at = std::ranges::lower_bound(drawn.curve.t, given[i].t);
    const auto point = static_cast<std::size_t>(at - drawn.curve.t.begin());
    // Scaling there and back rounds.
    result.line.curve.points[point] = given[i].position;
    result.line.pinned.push_back(point);
  }
  return result;
}

}  // namespace libstyle
