// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/curve_analogy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "libstyle/analogy/bent_line.h"
#include "libstyle/analogy/curve_assembly.h"
#include "libstyle/analogy/line_constraints.h"
#include "libstyle/analogy/line_search.h"
#include "libstyle/analogy/line_walk.h"
#include "libstyle/analogy/plain_lines.h"
#include "libstyle/analogy/soft_constraints.h"
#include "libstyle/analogy/style_grid.h"
#include "libstyle/base/error.h"
#include "libstyle/base/random.h"
#include "libstyle/geometry/arc_length.h"

namespace libstyle {
namespace {

constexpr double kMostSteps = 1 << 20;

// A constraint that is no farther off than this share of the reach of the style is left to the
// style; the line bends for the rest.
constexpr double kWithinReach = 0.5;

// Over how many feature sizes a line gives way to a soft constraint.
constexpr double kYieldReach = 3;

// Feature sizes over which a corner is looked at.
constexpr double kCornerReach = 0.5;

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
        walk_(example_, parameters) {
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

  CurveAnalogyParameters parameters_;
  Example example_;
  LineWalk walk_;
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
  StyleSummary summary =
      summarize(example_, walk_.jumps(), parameters_, walk_.mean_run(), walk_.longest_run());
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
  CurveAssembly assembly(curve, example_.features().size());
  for (std::size_t part = 0; part < lines.size(); ++part) {
    DrawnPart drawn =
        draw_line(lines[part].line, constraints.on(lines[part]), {task, random, part});
    assembly.append(std::move(drawn), lines[part], part + 1 == lines.size());
  }
  return assembly.take();
}

DrawnPart CurveAnalogy::Implementation::draw_line(const Polyline& line,
                                                  std::vector<LineConstraint> constraints,
                                                  const LinePlace& place) const {
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

DrawnPart CurveAnalogy::Implementation::draw_bent_line(const Polyline& line,
                                                       std::span<const LineConstraint> constraints,
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
    if (example_.has_strokes()) drawn.strokes = {drawn.line};
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

DrawnPart CurveAnalogy::Implementation::search_line(const Polyline& line, const StyleGrid& grid,
                                                    std::span<const LineConstraint> constraints,
                                                    const LinePlace& place) const {
  const double scale = grid.line_scale();
  LineSearch::Result drawn = search_->draw(line, scale, constraints,
                                           place.random.bits(place.part) >> 16, place.task.variant);
  return {std::move(drawn.line), {}, std::move(drawn.runs), scale * grid.length()};
}

DrawnPart CurveAnalogy::Implementation::walk_line(const Polyline& line, const StyleGrid& grid,
                                                  std::span<const LineConstraint> constraints,
                                                  const LinePlace& place) const {
  WalkedLine walked = walk_.draw(
      line, grid, constraints, {place.random, place.first(), place.before(), place.task.coherence});
  DrawnPart drawn{std::move(walked.line), std::move(walked.strokes), std::move(walked.runs),
                  grid.mean_scale() * grid.length(), std::move(walked.walk)};
  if (!example_.has_strokes()) return drawn;
  drawn.line = plain_line(line);
  if (drawn.strokes.empty()) drawn.strokes = {drawn.line};
  return drawn;
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
