// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/curve_analogy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "libstyle/analogy/bent_line.h"
#include "libstyle/analogy/jump_costs.h"
#include "libstyle/analogy/line_constraints.h"
#include "libstyle/analogy/line_search.h"
#include "libstyle/analogy/living_walk.h"
#include "libstyle/analogy/plain_lines.h"
#include "libstyle/analogy/shape_costs.h"
#include "libstyle/analogy/soft_constraints.h"
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

// A constraint that is no farther off than this share of the reach of the style is left to the
// style; the line bends for the rest.
constexpr double kWithinReach = 0.5;

// Over how many feature sizes a line gives way to a soft constraint.
constexpr double kYieldReach = 3;

// Feature sizes over which a corner is looked at.
constexpr double kCornerReach = 0.5;

// Lets the example come near the places that a line passes.
class HeldCosts {
 public:
  // A place on a line, and where the drawn line is to pass it: an offset in its frame and in the
  // size of the example.
  struct Place {
    double x = 0;  // style coordinate
    Vector offset;
  };

  explicit HeldCosts(const Example& example) : spread_(kHeldSpread * example.reach()) {
    for (std::size_t j = 0; j < example.state_count(); ++j) {
      const double start = example.length_of(j);
      const double least = kLeastStroke * example.feature_along();
      starts_.push_back(offsets_at(example.line(j), start, least));
      ends_.push_back(offsets_at(example.line(j), start + example.step(), -least));
    }
  }

  // For a line of so many steps that is held at these places; see StepCosts.
  bool add(std::size_t step, std::size_t steps, std::span<const Place> held,
           std::span<double> costs) const {
    bool any = false;
    for (const Place& place : held) {
      const auto border = static_cast<std::size_t>(std::lround(place.x));
      const bool at_end = border == steps && step + 1 == steps;
      if (border != step && !at_end) continue;
      const std::vector<std::vector<Vector>>& own = at_end ? ends_ : starts_;
      for (std::size_t j = 0; j < costs.size(); ++j) costs[j] += cost(own[j], place.offset);
      any = true;
    }
    return any;
  }

 private:
  // Of all strokes that go on as far as `inward`.
  static std::vector<Vector> offsets_at(const ExampleLine& line, double length, double inward) {
    std::vector<Vector> result;
    for (const Lane& lane : line.lanes()) {
      if (!lane.is_down(length) || !lane.is_down(length + inward)) continue;
      result.push_back(lane.at(length).offset);
    }
    return result;
  }

  // Of the stroke that is nearest.
  double cost(std::span<const Vector> strokes, Vector wanted) const {
    if (strokes.empty()) return kPenUp;
    if (!(spread_ > 0)) return 0;
    double least = std::numeric_limits<double>::infinity();
    for (const Vector offset : strokes) least = std::min(least, squared_norm(offset - wanted));
    return least / (2 * spread_ * spread_);
  }

  double spread_;
  std::vector<std::vector<Vector>> starts_, ends_;  // for each state, of its strokes
};

// Where a drawn line is that far along the plain one, which is `total` long.
Point place_on(const DrawnLine& drawn, double length, double total) {
  const auto after = std::ranges::upper_bound(drawn.lengths, length);
  const auto b = static_cast<std::size_t>(after - drawn.lengths.begin());
  const std::vector<Point>& points = drawn.curve.points;
  if (b == 0 || (b == points.size() && !drawn.curve.closed)) return points[b == 0 ? 0 : b - 1];
  const double from = drawn.lengths[b - 1];
  const double to = b < points.size() ? drawn.lengths[b] : total;
  const double share = to > from ? std::min((length - from) / (to - from), 1.0) : 0;
  return lerp(points[b - 1], points[b < points.size() ? b : 0], share);
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
  DrawnLine plain_line(const Polyline& line) const;
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

  DrawnPart draw_line(const Polyline& line, std::vector<LineConstraint> constraints,
                      const LinePlace& place) const;
  void settle_soft_constraints(const Polyline& line, const LinePlace& place,
                               std::vector<LineConstraint>& constraints) const;
  DrawnPart draw_bent_line(const Polyline& line, std::span<const LineConstraint> constraints,
                           const LinePlace& place) const;
  BentLine bend(const Polyline& line, std::span<const LineConstraint> constraints,
                const StyleGrid& grid, double within_reach) const;
  DrawnPart search_line(const Polyline& line, const StyleGrid& grid,
                        std::span<const LineConstraint> constraints, const LinePlace& place) const;
  DrawnPart walk_line(const Polyline& line, const StyleGrid& grid,
                      std::span<const LineConstraint> constraints, const LinePlace& place) const;
  std::vector<ChainState> walk_randomly(const Sweep& line, const StyleGrid& grid,
                                        std::span<const HeldPlace> held,
                                        const LinePlace& place) const;
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

DrawnLine CurveAnalogy::Implementation::plain_line(const Polyline& line) const {
  StyledCurve plain = unchanged(line);
  return {std::move(plain.curve), std::move(plain.lengths), std::move(plain.features)};
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
  const LineConstraints constraints(
      curve, lines, {task.held, task.constraints, parameters_.keep_ends, example_.feature_size()});
  StyledCurve result;
  result.curve.closed = curve.closed;
  result.features.resize(example_.features().size());
  double total = 0, scaled = 0;
  std::size_t first_step = 0;
  for (std::size_t part = 0; part < lines.size(); ++part) {
    DrawnPart drawn =
        draw_line(lines[part].line, constraints.on(lines[part]), {task, random, part});
    result.walks.push_back(std::move(drawn.walk));
    const bool joins = !drawn.line.curve.closed && (curve.closed || part + 1 < lines.size());
    if (lines[part].starts_at_corner) result.corners.push_back(result.curve.points.size());
    const std::size_t count = drawn.line.curve.points.size() - (joins ? 1 : 0);
    for (const std::size_t i : drawn.line.pinned) {
      const bool is_end = i == 0 || i + 1 == drawn.line.curve.points.size();
      if (is_end && !drawn.line.curve.closed) continue;
      result.pinned.push_back(result.curve.points.size() + i);
    }
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
    const Polyline& line, std::vector<LineConstraint> constraints, const LinePlace& place) const {
  // The search weighs soft constraints itself.
  if (!search_) settle_soft_constraints(line, place, constraints);
  return draw_bent_line(line, constraints, place);
}

// Soft constraints become hard ones at the places that they and the line, as it goes without them,
// agree on.
void CurveAnalogy::Implementation::settle_soft_constraints(
    const Polyline& line, const LinePlace& place, std::vector<LineConstraint>& constraints) const {
  std::vector<LineConstraint> hard;
  for (const LineConstraint& constraint : constraints) {
    if (!constraint.weight) hard.push_back(constraint);
  }
  if (hard.size() == constraints.size()) return;

  // From frame to frame it stays as it was settled in the first.
  CurveTask task = place.task;
  if (!place.before().empty()) {
    task.before = nullptr;
    task.variant = 0;
  }
  const RandomStream random(parameters_.seed + task.variant, task.place);
  const DrawnPart drawn = draw_bent_line(line, hard, {task, random, place.part});
  const double total = arc_length(line);
  std::vector<Pull> pulls;
  for (const LineConstraint& constraint : constraints) {
    Pull pull{constraint.length, {}, constraint.weight};
    if (pull.weight) pull.offset = *constraint.position - place_on(drawn.line, pull.length, total);
    pulls.push_back(pull);
  }
  std::optional<double> period;
  if (line.closed) period = total;
  const Stiffness stiffness{example_.feature_size(), kYieldReach * example_.feature_along()};
  const std::vector<Vector> offsets = yielding_offsets(pulls, stiffness, period);
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    if (!constraints[i].weight) continue;
    *constraints[i].position += offsets[i] - pulls[i].offset;
    constraints[i].weight.reset();
  }
}

CurveAnalogy::Implementation::DrawnPart CurveAnalogy::Implementation::draw_bent_line(
    const Polyline& line, std::span<const LineConstraint> constraints,
    const LinePlace& place) const {
  StyleGrid grid(line, example_, parameters_);
  BentLine bent(line);
  if (std::ranges::any_of(constraints, [](const auto& c) { return c.position.has_value(); })) {
    bent = bend(line, constraints, grid, kWithinReach);
    grid = StyleGrid(bent.line(), example_, parameters_);
  }
  DrawnPart drawn;
  if (grid.line_scale() <= parameters_.smallest_scale && parameters_.smallest_scale < 1) {
    bent = bend(line, constraints, grid, 0);
    drawn.line = plain_line(bent.line());
    drawn.strokes = {drawn.line};
  } else {
    std::vector<LineConstraint> along_bent(constraints.begin(), constraints.end());
    for (LineConstraint& c : along_bent) c.length = bent.bent_length(c.length);
    drawn = search_ ? search_line(bent.line(), grid, along_bent, place)
                    : walk_line(bent.line(), grid, along_bent, place);
  }
  for (double& length : drawn.line.lengths) length = bent.plain_length(length);
  for (DrawnLine& stroke : drawn.strokes) {
    for (double& length : stroke.lengths) length = bent.plain_length(length);
  }
  return drawn;
}

// Each hard constraint that is farther off than the style goes by itself, by that share of its
// reach, moves the line; all other places that are held keep theirs.
BentLine CurveAnalogy::Implementation::bend(const Polyline& line,
                                            std::span<const LineConstraint> constraints,
                                            const StyleGrid& grid, double within_reach) const {
  const ArcLength along(line);
  std::vector<Bend> bends;
  bool any = false;
  for (const LineConstraint& constraint : constraints) {
    if (constraint.weight) continue;
    Bend bend{constraint.length, {}};
    if (constraint.position) {
      const Vector whole = *constraint.position - along.point_at(constraint.length);
      if (!(norm(whole) <= longest_curve())) {
        throw Error("the constraint at " + text_of(*constraint.position) +
                    " is too far away: the line to it would be over a million times as long as a "
                    "step of the style");
      }
      const double reach =
          within_reach * example_.reach() * grid.scale_at(grid.coordinate_at(constraint.length));
      if (norm(whole) > reach) bend.offset = (1 - reach / norm(whole)) * whole;
    }
    any = any || norm(bend.offset) > 0;
    bends.push_back(bend);
  }
  if (!any) return BentLine(line);
  return {line, bends, grid.line_scale() * example_.feature_along()};
}

CurveAnalogy::Implementation::DrawnPart CurveAnalogy::Implementation::search_line(
    const Polyline& line, const StyleGrid& grid, std::span<const LineConstraint> constraints,
    const LinePlace& place) const {
  const double scale = grid.line_scale();
  LineSearch::Result drawn = search_->draw(line, scale, constraints,
                                           place.random.bits(place.part) >> 16, place.task.variant);
  return {std::move(drawn.line), {}, std::move(drawn.runs), scale * grid.length()};
}

CurveAnalogy::Implementation::DrawnPart CurveAnalogy::Implementation::walk_line(
    const Polyline& line, const StyleGrid& grid, std::span<const LineConstraint> constraints,
    const LinePlace& place) const {
  const double end = arc_length(line);
  std::vector<HeldPlace> held;
  for (const LineConstraint& constraint : constraints) {
    const bool is_end = !line.closed && constraint.length == end;
    held.push_back(
        {is_end ? static_cast<double>(grid.steps()) : grid.coordinate_at(constraint.length),
         constraint.position});
  }
  const double blur = grid.line_scale() * example_.feature_along();
  const Sweep sweep(line, parameters_.smoothing * blur, blur, parameters_.invariance);
  std::vector<ChainState> walk = parameters_.shape_weight > 0
                                     ? walk_by_shape(sweep, grid)
                                     : walk_randomly(sweep, grid, held, place);
  DrawnPart result{{}, {}, find_runs(example_, walk), grid.mean_scale() * grid.length()};
  result.walk = std::move(walk);
  if (!example_.has_strokes()) {
    result.line = draw_walk(example_, sweep, grid, result.walk, held);
    return result;
  }
  result.strokes = draw_strokes(example_, sweep, grid, result.walk, held);
  result.line = plain_line(line);
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

std::vector<ChainState> CurveAnalogy::Implementation::walk_randomly(const Sweep& line,
                                                                    const StyleGrid& grid,
                                                                    std::span<const HeldPlace> held,
                                                                    const LinePlace& place) const {
  std::vector<HeldCosts::Place> places;
  for (const auto& [x, position] : held) {
    places.push_back({x, {}});
    if (!position) continue;
    const double length = grid.length_at(x);
    places.back().offset =
        to_frame(*position - line.point_at(length), line.frame_at(length)) / grid.scale_at(x);
  }
  ChainTask task;
  task.steps = grid.steps();
  task.costs = [&, steps = task.steps](std::size_t step, std::span<double> costs) {
    return held_costs_.add(step, steps, places, costs);
  };
  const std::span<const ChainState> before = place.before();
  if (before.size() == task.steps) {
    const double piece = kPiece * example_.feature_along() / example_.step();
    const WalkChange change{1 - place.task.coherence, static_cast<std::size_t>(piece) + 1,
                            line.closed(), variety()};
    return changed_walk(jumps_.chain, task, before, change, place.random, place.first());
  }
  if (line.closed()) {
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
