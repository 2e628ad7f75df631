// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/curve_analogy.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "libstyle/analogy/jump_costs.h"
#include "libstyle/analogy/line_search.h"
#include "libstyle/analogy/living_walk.h"
#include "libstyle/analogy/plain_lines.h"
#include "libstyle/analogy/shape_costs.h"
#include "libstyle/analogy/style_grid.h"
#include "libstyle/base/error.h"
#include "libstyle/base/random.h"
#include "libstyle/geometry/arc_length.h"

namespace libstyle {
namespace {

// How far off a line that is held a walk may be there, as a share of the reach of the style: what
// is left over is bent into place.
constexpr double kHeldSpread = 0.15;

// What it costs that no stroke is there: as a stroke four spreads off. One that goes on for so many
// feature sizes is one.
constexpr double kPenUp = 8;
constexpr double kLeastStroke = 0.6;

constexpr double kMeanRun = 8;  // feature sizes

// The longest run: a share of the example, but not less than so many feature sizes.
constexpr double kLongestRun = 0.2;
constexpr double kLeastLongestRun = 2.5;
constexpr double kRepeatFactor = 0.25;  // for each time that a place was used before on the line

constexpr double kMostSteps = 1 << 20;

// Feature sizes that change together from frame to frame. Given what is at both ends, pieces no
// longer than a run hardly ever change: the walk would have to jump away and back.
constexpr double kPiece = 20;

// Places nearer to each other, or to an end, than this share of a line are held as one.
constexpr double kHeldApart = 1e-6;

// Feature sizes over which a corner is looked at.
constexpr double kCornerReach = 0.5;

// Lets the example cross its unfiltered curve where a line is held in its place.
class HeldCosts {
 public:
  explicit HeldCosts(const Example& example) {
    const double spread = kHeldSpread * example.reach();
    for (std::size_t j = 0; j < example.state_count(); ++j) {
      const double start = example.length_of(j);
      const double least = kLeastStroke * example.feature_along();
      starts_.push_back(cost(example.line(j), start, least, spread));
      ends_.push_back(cost(example.line(j), start + example.step(), -least, spread));
    }
  }

  // For a line of so many steps that is held at these coordinates; see StepCosts.
  bool add(std::size_t step, std::size_t steps, std::span<const double> held,
           std::span<double> costs) const {
    bool any = false;
    for (const double x : held) {
      const auto border = static_cast<std::size_t>(std::lround(x));
      const bool at_end = border == steps && step + 1 == steps;
      if (border != step && !at_end) continue;
      const std::vector<double>& own = at_end ? ends_ : starts_;
      for (std::size_t j = 0; j < costs.size(); ++j) costs[j] += own[j];
      any = true;
    }
    return any;
  }

 private:
  // Of the stroke that is nearest, of those that go on as far as `inward`.
  static double cost(const ExampleLine& line, double length, double inward, double spread) {
    std::optional<double> least;
    for (const Lane& lane : line.lanes()) {
      if (!lane.is_down(length) || !lane.is_down(length + inward)) continue;
      const double off = squared_norm(lane.at(length).offset);
      const double own = spread > 0 ? off / (2 * spread * spread) : 0;
      least = std::min(own, least.value_or(own));
    }
    return least.value_or(kPenUp);
  }

  std::vector<double> starts_, ends_;
};

// Where a line of the curve is held, from where the curve is: in its style coordinates, rising.
std::vector<double> held_coordinates(const StyleGrid& grid, bool open,
                                     std::span<const double> held_lengths) {
  std::vector<double> result;
  const double margin = kHeldApart * grid.length();
  double last = open ? 0 : -margin;
  const double end = open ? grid.length() : grid.length() + margin;
  if (open) result.push_back(0);
  for (const double length : held_lengths) {
    if (length < last + margin || length > end - margin) continue;
    result.push_back(grid.coordinate_at(length));
    last = length;
  }
  if (open) result.push_back(static_cast<double>(grid.steps()));
  return result;
}

// Lengths along a curve as lengths along one of its lines, rising; a line may go on past the seam.
std::vector<double> lengths_on(const PlainLine& line, double curve_length,
                               std::span<const double> held) {
  const double end = arc_length(line.line);
  std::vector<double> result;
  for (const double length : held) {
    for (const double turn : {0.0, curve_length}) {
      const double own = length + turn - line.length_before;
      if (own >= 0 && own <= end) result.push_back(own);
    }
  }
  std::ranges::sort(result);
  return result;
}

}  // namespace

class CurveAnalogy::Implementation {
 public:
  Implementation(std::span<const ExamplePair> pairs, const CurveAnalogyParameters& parameters)
      : parameters_((validate(parameters), parameters)),
        example_(pairs, parameters),
        jumps_(make_jump_model(example_, parameters.mean_run.value_or(kMeanRun),
                               parameters.shape_weight > 0)),
        held_costs_(example_) {
    if (parameters.method != AnalogyMethod::kGreedy) return;
    if (example_.has_strokes()) {
      throw Error(
          "the greedy search draws a line as one stroke, and the example has several for one; use "
          "the chain, or draw one stroke for each unfiltered curve");
    }
    search_.emplace(example_, parameters);
  }

  StyledCurve draw(const Polyline& curve, const CurveTask& task) const;

  const Example& example() const { return example_; }
  double longest_curve() const {
    const double longest = kMostSteps * example_.step();
    return search_ ? std::min(longest, search_->longest_line()) : longest;
  }
  StyleSummary summary() const;

 private:
  StyledCurve unchanged(const Polyline& curve) const;
  StyledCurve too_long(const Polyline& curve) const;
  struct DrawnPart {
    DrawnLine line;
    std::vector<DrawnLine> strokes;
    std::vector<ChainRun> runs;
    double scaled_length = 0;
    std::vector<ChainState> walk = {};
  };

  // What is the same for all lines of a curve, and which of them it is.
  struct LinePlace {
    const CurveTask& task;
    const RandomStream& random;
    std::uint64_t part = 0;

    std::uint64_t first() const { return part << 32; }  // random number
    // The walk of the frame before; nothing if there is none to change.
    std::span<const ChainState> before() const {
      if (!task.before || task.coherence <= 0 || part >= task.before->size()) return {};
      return (*task.before)[part];
    }
  };

  DrawnPart draw_line(const Polyline& line, std::span<const double> held_lengths,
                      const LinePlace& place) const;
  std::vector<ChainState> walk_randomly(const StyleGrid& grid, bool closed,
                                        std::span<const double> held, const LinePlace& place) const;
  std::vector<ChainState> walk_by_shape(const Sweep& line, const StyleGrid& grid) const;
  ChainState random_origin(const RandomStream& random, std::uint64_t first) const;
  ChainVariety variety() const;

  CurveAnalogyParameters parameters_;
  Example example_;
  JumpModel jumps_;
  HeldCosts held_costs_;
  std::optional<LineSearch> search_;
};

// Where nothing is drawn, features are what they are on average where the style is smallest.
StyledCurve CurveAnalogy::Implementation::unchanged(const Polyline& curve) const {
  StyledCurve result;
  result.curve = curve;
  result.lengths = cumulative_lengths(curve);
  result.lengths.resize(curve.points.size());
  for (std::size_t i = 0; i < example_.features().size(); ++i) {
    const bool is_length = example_.features()[i].kind == FeatureKind::kLength;
    const double value = (is_length ? parameters_.smallest_scale : 1) * example_.statistics(i).mean;
    result.features.emplace_back(curve.points.size(), value);
  }
  return result;
}

StyledCurve CurveAnalogy::Implementation::too_long(const Polyline& curve) const {
  StyledCurve result = unchanged(curve);
  result.too_long = true;
  return result;
}

StyleSummary CurveAnalogy::Implementation::summary() const {
  const bool samples_the_chain = parameters_.shape_weight == 0;
  StyleSummary summary =
      summarize(example_, jumps_, parameters_, parameters_.mean_run.value_or(kMeanRun),
                samples_the_chain ? variety().longest_run : 0);
  if (search_) summary.search = search_->summary();
  return summary;
}

StyledCurve CurveAnalogy::Implementation::draw(const Polyline& curve, const CurveTask& task) const {
  for (const Point p : curve.points) {
    if (!is_finite(p)) throw Error("a curve has a coordinate that is not finite");
  }
  // Lengths that overflow are too long as well.
  if (!curve.points.empty() && !(arc_length(curve) <= longest_curve())) return too_long(curve);
  std::optional<double> corner_angle;
  if (parameters_.shape_weight == 0) {
    corner_angle = parameters_.corner_angle * std::numbers::pi / 180;
  }
  const std::vector<PlainLine> lines =
      split_into_lines(curve, corner_angle, kCornerReach * example_.feature_along());
  if (lines.empty()) return unchanged(curve);

  const RandomStream random(parameters_.seed + task.variant, task.place);
  const double curve_length = arc_length(curve);
  StyledCurve result;
  result.curve.closed = curve.closed;
  result.features.resize(example_.features().size());
  double total = 0, scaled = 0;
  std::size_t first_step = 0;
  for (std::size_t part = 0; part < lines.size(); ++part) {
    DrawnPart drawn = draw_line(lines[part].line, lengths_on(lines[part], curve_length, task.held),
                                {task, random, part});
    result.walks.push_back(std::move(drawn.walk));
    const bool joins = !drawn.line.curve.closed && (curve.closed || part + 1 < lines.size());
    if (lines[part].starts_at_corner) result.corners.push_back(result.curve.points.size());
    const std::size_t count = drawn.line.curve.points.size() - (joins ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) {
      result.curve.points.push_back(drawn.line.curve.points[i]);
      result.lengths.push_back(lines[part].length_before + drawn.line.lengths[i]);
    }
    for (std::size_t i = 0; i < result.features.size(); ++i) {
      const std::vector<double>& own = drawn.line.features[i];
      result.features[i].insert(result.features[i].end(), own.begin(),
                                own.begin() + static_cast<std::ptrdiff_t>(count));
    }
    for (DrawnLine& stroke : drawn.strokes) {
      for (double& length : stroke.lengths) length += lines[part].length_before;
      if (example_.has_strokes()) result.strokes.push_back(std::move(stroke));
    }
    for (ChainRun& run : drawn.runs) {
      run.first += first_step;
      result.runs.push_back(run);
    }
    if (!result.runs.empty()) first_step = result.runs.back().first + result.runs.back().steps;
    const double length = arc_length(lines[part].line);
    total += length;
    scaled += drawn.scaled_length;
  }
  result.mean_scale = scaled / total;
  return result;
}

CurveAnalogy::Implementation::DrawnPart CurveAnalogy::Implementation::draw_line(
    const Polyline& line, std::span<const double> held_lengths, const LinePlace& place) const {
  const StyleGrid grid(line, example_, parameters_);
  if (grid.line_scale() <= parameters_.smallest_scale && parameters_.smallest_scale < 1) {
    StyledCurve plain = unchanged(line);
    DrawnLine same{std::move(plain.curve), std::move(plain.lengths), std::move(plain.features)};
    return {same, {same}, {}, 0};
  }
  std::vector<double> held;
  if (parameters_.keep_ends) held = held_coordinates(grid, !line.closed, held_lengths);
  if (search_) {
    for (double& x : held) x = grid.length_at(x);
    const double scale = grid.line_scale();
    LineSearch::Result drawn =
        search_->draw(line, scale, held, place.random.bits(place.part) >> 16, place.task.variant);
    return {std::move(drawn.line), {}, std::move(drawn.runs), scale * grid.length()};
  }
  const double blur = grid.line_scale() * example_.feature_along();
  const Sweep sweep(line, parameters_.smoothing * blur, blur, parameters_.invariance);
  std::vector<ChainState> walk = parameters_.shape_weight > 0
                                     ? walk_by_shape(sweep, grid)
                                     : walk_randomly(grid, line.closed, held, place);
  DrawnPart result{{}, {}, find_runs(example_, walk), grid.mean_scale() * grid.length()};
  result.walk = std::move(walk);
  if (!example_.has_strokes()) {
    result.line = draw_walk(example_, sweep, grid, result.walk, held);
    return result;
  }
  result.strokes = draw_strokes(example_, sweep, grid, result.walk, held);
  StyledCurve plain = unchanged(line);
  result.line = {std::move(plain.curve), std::move(plain.lengths), std::move(plain.features)};
  if (result.strokes.empty()) result.strokes = {result.line};
  return result;
}

// A jump lands most likely where closing the curve is easiest.
ChainState CurveAnalogy::Implementation::random_origin(const RandomStream& random,
                                                       std::uint64_t first) const {
  std::vector<double> arrivals(example_.state_count());
  for (std::size_t j = 0; j < arrivals.size(); ++j) arrivals[j] = jumps_.chain.landing[j] * 1e-9;
  for (const ChainRow& row : jumps_.chain.rows) {
    for (const ChainJump& jump : row.jumps) arrivals[jump.target] += jump.probability;
  }
  return static_cast<ChainState>(random.choose(first, arrivals));
}

std::vector<ChainState> CurveAnalogy::Implementation::walk_randomly(const StyleGrid& grid,
                                                                    bool closed,
                                                                    std::span<const double> held,
                                                                    const LinePlace& place) const {
  ChainTask task;
  task.steps = grid.steps();
  task.costs = [&, steps = task.steps](std::size_t step, std::span<double> costs) {
    return held_costs_.add(step, steps, held, costs);
  };
  const std::span<const ChainState> before = place.before();
  if (before.size() == task.steps) {
    const double piece = kPiece * example_.feature_along() / example_.step();
    const WalkChange change{1 - place.task.coherence, static_cast<std::size_t>(piece) + 1, closed,
                            variety()};
    return changed_walk(jumps_.chain, task, before, change, place.random, place.first());
  }
  if (closed) {
    task.origin = random_origin(place.random, place.first());
    task.next = task.origin;
  }
  return sample_chain(jumps_.chain, task, place.random, place.first(), variety());
}

ChainVariety CurveAnalogy::Implementation::variety() const {
  const double least = kLeastLongestRun * example_.feature_along() / example_.step();
  const double share = kLongestRun * static_cast<double>(example_.state_count());
  return {static_cast<std::size_t>(std::max(share, least)), kRepeatFactor};
}

// A closed line is walked twice round first: where that passes half-way it no longer feels its
// ends, and the state there is where the closed walk begins.
std::vector<ChainState> CurveAnalogy::Implementation::walk_by_shape(const Sweep& line,
                                                                    const StyleGrid& grid) const {
  const ShapeCosts shape(example_, line, grid, parameters_.shape_weight, jumps_.tolerance);
  ChainTask task;
  task.steps = grid.steps();
  task.costs = [&](std::size_t step, std::span<double> costs) {
    shape.add(step % grid.steps(), costs);
    return true;
  };
  if (!line.closed()) return best_chain(jumps_.chain, task);
  task.steps = 2 * grid.steps();
  task.origin = best_chain(jumps_.chain, task)[grid.steps()];
  task.steps = grid.steps();
  task.next = task.origin;
  return best_chain(jumps_.chain, task);
}

CurveAnalogy::CurveAnalogy(std::span<const ExamplePair> pairs,
                           const CurveAnalogyParameters& parameters)
    : implementation_(std::make_unique<Implementation>(pairs, parameters)) {}
CurveAnalogy::~CurveAnalogy() = default;
CurveAnalogy::CurveAnalogy(CurveAnalogy&&) noexcept = default;
CurveAnalogy& CurveAnalogy::operator=(CurveAnalogy&&) noexcept = default;

StyledCurve CurveAnalogy::draw(const Polyline& curve, const CurveTask& task) const {
  return implementation_->draw(curve, task);
}

double CurveAnalogy::longest_curve() const { return implementation_->longest_curve(); }

const Example& CurveAnalogy::example() const { return implementation_->example(); }

StyleSummary CurveAnalogy::summary() const { return implementation_->summary(); }

StyledCurve draw_by_analogy(const ExamplePair& pair, const Polyline& curve,
                            const CurveAnalogyParameters& parameters) {
  return CurveAnalogy({&pair, 1}, parameters).draw(curve, {});
}

}  // namespace libstyle
