// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/cubic_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/corners.h"
#include "libstyle/geometry/cubic_segment_fit.h"
#include "libstyle/geometry/polygon.h"

namespace libstyle {
namespace {

// --- Samples ------------------------------------------------------------------------------------

// Most samples put on one edge.
constexpr double kMaxInserted = 16;

// The vertices of a span in order, repeats left out, with the polyline's indices.
struct Chain {
  std::vector<Point> points;
  std::vector<std::size_t> vertices;
};

// An edge seen as the chord of an arc.
struct EdgeArc {
  Vector height;       // from the chord's middle to the arc
  double samples = 1;  // how many to put on it, as a measure of how straight it is meant
};

// The arc is no more bent than the calmer end of the edge. An edge far longer than its neighbours
// is meant to be straight: their arc, carried on, is no measure for it.
EdgeArc arc_over_edge(const std::vector<Point>& points, std::size_t edge) {
  const Vector along = points[edge + 1] - points[edge];
  const bool has_before = edge > 0, has_after = edge + 2 < points.size();
  const Vector before = has_before ? points[edge] - points[edge - 1] : Vector{};
  const Vector after = has_after ? points[edge + 2] - points[edge + 1] : Vector{};
  double turn = has_before ? turning_angle(before, along) : turning_angle(along, after);
  const double turn_after = has_after ? turning_angle(along, after) : turn;
  if (turn * turn_after <= 0) turn = 0;
  if (std::abs(turn_after) < std::abs(turn)) turn = turn_after;
  const double length = norm(along), neighbour = std::max(norm(before), norm(after));
  const double bent_length = std::min(length, 2 * neighbour);
  // Clockwise turns bulge to the left.
  const Vector left = Vector{along.y, -along.x} / length;
  return {bent_length * turn / 8 * left,
          std::clamp(neighbour > 0 ? length / neighbour : 0, 1.0, kMaxInserted)};
}

// Edges longer than `reach` get samples of their own, so that the path does not wander off there.
std::vector<ArcSample> make_samples(const Chain& chain, double reach) {
  std::vector<ArcSample> samples;
  double length = 0;
  for (std::size_t i = 0; i < chain.points.size(); ++i) {
    samples.push_back({chain.points[i], length, 0, chain.vertices[i]});
    if (i + 1 == chain.points.size()) break;
    const double edge = distance(chain.points[i], chain.points[i + 1]);
    if (edge > reach) {
      const EdgeArc arc = arc_over_edge(chain.points, i);
      const auto inserted = static_cast<int>(arc.samples);
      for (int k = 1; k <= inserted; ++k) {
        const double share = static_cast<double>(k) / (inserted + 1);
        samples.push_back({lerp(chain.points[i], chain.points[i + 1], share) +
                               4 * share * (1 - share) * arc.height,
                           length + share * edge, 0, kNoVertex});
      }
    }
    length += edge;
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double before = samples[i > 0 ? i - 1 : i].length;
    const double after = samples[std::min(i + 1, samples.size() - 1)].length;
    samples[i].weight = (after - before) / 2;
  }
  return samples;
}

// --- One span -----------------------------------------------------------------------------------

struct SpanFit {
  std::vector<CubicBezier> curves;
  std::vector<std::size_t> ends;  // the vertex at the end of each curve
  double error = 0;
};

constexpr int kBalancingRounds = 4;

// Fits segments to samples [first, last], between which any vertex may be a break. What lies beyond
// takes part in the directions only; where there is nothing beyond, the position is fixed.
class SpanFitter {
 public:
  SpanFitter(std::vector<ArcSample> samples, std::size_t first, std::size_t last,
             const LocalFitParams& params)
      : samples_(std::move(samples)), params_(params), frames_(samples_.size()) {
    for (std::size_t i = first; i <= last; ++i) {
      if (samples_[i].vertex != kNoVertex) breaks_.push_back(i);
    }
    stops_ = {breaks_.size() - 1};
  }

  // Every segment ends at these vertices, rising, and passes them exactly.
  void pass_through(std::span<const std::size_t> vertices) {
    stops_.clear();
    for (std::size_t i = 0; i < breaks_.size(); ++i) {
      const ArcSample& sample = samples_[breaks_[i]];
      const bool asked = std::ranges::binary_search(vertices, sample.vertex);
      if (asked) frames_[breaks_[i]] = {sample.position, frame(breaks_[i]).tangent};
      if (asked || i + 1 == breaks_.size()) stops_.push_back(i);
    }
  }

  // The first and last sample are the same place of a closed curve.
  void join_ends() { frames_[breaks_.back()] = frame(breaks_.front()); }

  SpanFit fit() {
    SpanFit best = *fit_greedily(params_.tolerance, breaks_.size());
    if (best.curves.size() == 1) return best;
    double low = 0, high = params_.tolerance;
    for (int round = 0; round < kBalancingRounds; ++round) {
      const double middle = (low + high) / 2;
      std::optional<SpanFit> fit = fit_greedily(middle, best.curves.size());
      if (fit && fit->error <= std::max(middle, best.error)) {
        best = std::move(*fit);
        high = middle;
      } else {
        low = middle;
      }
    }
    return best;
  }

 private:
  const LocalFit& frame(std::size_t sample) {
    std::optional<LocalFit>& known = frames_[sample];
    if (!known) known = fit_locally(samples_, sample, params_);
    return *known;
  }

  // From break `from` to break `to`.
  std::optional<SegmentFit> fit_segment(std::size_t from, std::size_t to, double tolerance) {
    const std::size_t first = breaks_[from], last = breaks_[to];
    return fitter_.fit(std::span(samples_).subspan(first, last - first + 1), frame(first),
                       frame(last), tolerance);
  }

  // The longest segment from break `from` that is found; `to` is a first guess of its end, and
  // becomes it.
  SegmentFit longest_segment(std::size_t from, std::size_t& to, double tolerance) {
    const std::size_t last = *std::ranges::upper_bound(stops_, from);
    std::optional<SegmentFit> best;
    std::size_t reached = from, failed = last + 1;
    std::size_t step = std::max<std::size_t>(to - from, 1);
    while (failed - reached > 1) {
      // Doubling until something fails, then halving the gap.
      std::size_t next = failed > last ? std::min(reached + step, last) : (reached + failed) / 2;
      if (failed > last && reached > from) step *= 2;
      if (std::optional<SegmentFit> fit = fit_segment(from, next, tolerance)) {
        best = fit;
        reached = next;
      } else {
        failed = next;
      }
    }
    to = std::max(reached, from + 1);
    if (best) return *best;
    const std::size_t first = breaks_[from], second = breaks_[from + 1];
    return fitter_.fit_neighbours(std::span(samples_).subspan(first, second - first + 1),
                                  frame(first), frame(second), params_.tolerance);
  }

  // Nothing if it takes more than `limit` segments.
  std::optional<SpanFit> fit_greedily(double tolerance, std::size_t limit) {
    SpanFit result;
    std::size_t from = 0, stride = 8;
    while (from + 1 < breaks_.size()) {
      if (result.curves.size() == limit) return std::nullopt;
      std::size_t to = from + stride;
      const SegmentFit segment = longest_segment(from, to, tolerance);
      result.curves.push_back(segment.curve);
      result.ends.push_back(samples_[breaks_[to]].vertex);
      result.error = std::max(result.error, segment.error);
      stride = to - from;
      from = to;
    }
    return result;
  }

  std::vector<ArcSample> samples_;
  LocalFitParams params_;
  std::vector<std::size_t> breaks_;  // samples at which segments may begin and end
  std::vector<std::size_t> stops_;   // breaks at which they must; the last one always
  std::vector<std::optional<LocalFit>> frames_;
  SegmentFitter fitter_;
};

// The largest distance of the points from their chord, or nothing if it is more than `limit` or
// they go back along it by more than that.
std::optional<double> deviation_from_chord(std::span<const Point> points, double limit) {
  const Vector chord = points.back() - points.front();
  const Vector along = normalized(chord);
  double worst = 0, furthest = 0;
  for (const Point point : points) {
    const Vector offset = point - points.front();
    const double progress = dot(along, offset);
    if (progress < furthest - limit) return std::nullopt;
    furthest = std::max(furthest, progress);
    const double on_chord = std::clamp(progress, 0.0, norm(chord));
    worst = std::max(worst, norm(offset - on_chord * along));
  }
  if (!(worst <= limit)) return std::nullopt;
  return worst;
}

// --- The path -----------------------------------------------------------------------------------

void validate(const Polyline& polyline, const CubicFitParams& params) {
  if (!(params.tolerance > 0) || !std::isfinite(params.tolerance)) {
    throw Error("fit: tolerance must be a positive number");
  }
  if (!(params.corner_angle >= 0 && params.corner_angle <= std::numbers::pi)) {
    throw Error("fit: corner_angle must be between 0 and pi");
  }
  if (!(params.corner_reach >= 0) || !std::isfinite(params.corner_reach)) {
    throw Error("fit: corner_reach must not be negative");
  }
  if (!std::isfinite(arc_length(polyline))) {
    throw Error("fit: a point is not finite or too far away to measure");
  }
}

class PathFitter {
 public:
  PathFitter(const Polyline& polyline, const CubicFitParams& params,
             std::span<const std::size_t> through)
      : polyline_(polyline),
        through_(through),
        tolerance_(params.tolerance),
        reach_(params.corner_reach > 0 ? params.corner_reach : 4 * params.tolerance),
        corners_(find_corners(polyline, {params.corner_angle, reach_})) {}

  CubicFit fit() {
    if (polyline_.points.empty()) return {};
    if (!polyline_.closed) {
      fit_open();
    } else if (corners_.empty()) {
      fit_smooth_loop();
    } else {
      fit_loop_with_corners();
    }
    return std::move(result_);
  }

 private:
  // For a span of some length: a dot smaller than the tolerance is still to look like itself.
  LocalFitParams local_params(double length) const {
    return {std::min(reach_, length / 8), std::min(tolerance_, length / 16)};
  }

  void begin_at(std::size_t vertex, bool corner) {
    result_.path.move_to(polyline_.points[vertex]);
    result_.points.push_back(vertex);
    result_.corners.push_back(corner);
  }

  void fit_open() {
    begin_at(0, false);
    std::size_t from = 0;
    for (const std::size_t corner : corners_) {
      append_span(chain_between(from, corner), true);
      from = corner;
    }
    append_span(chain_between(from, polyline_.points.size() - 1), false);
  }

  void fit_loop_with_corners() {
    begin_at(corners_.front(), true);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      append_span(chain_between(corners_[i], corners_[(i + 1) % corners_.size()]), true);
    }
    result_.path.close();
  }

  // The curve three times round; the fit is made for the middle one, so that directions at its ends
  // come from both sides.
  void fit_smooth_loop() {
    const Chain once = chain_between(0, 0);
    begin_at(0, false);
    if (once.points.size() > 2) {
      Chain thrice = once;
      for (int turn = 0; turn < 2; ++turn) {
        thrice.points.insert(thrice.points.end(), once.points.begin() + 1, once.points.end());
        thrice.vertices.insert(thrice.vertices.end(), once.vertices.begin() + 1,
                               once.vertices.end());
      }
      append_loop(make_samples(thrice, reach_), once.points.size() - 1);
    }
    result_.path.close();
  }

  void append_loop(std::vector<ArcSample> samples, std::size_t edges) {
    std::size_t first = 0, last = 0, vertices = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (samples[i].vertex == kNoVertex) continue;
      if (vertices == edges) first = i;
      if (vertices == 2 * edges) last = i;
      ++vertices;
    }
    const LocalFitParams params = local_params(samples[last].length - samples[first].length);
    SpanFitter fitter(std::move(samples), first, last, params);
    fitter.pass_through(through_);
    fitter.join_ends();
    SpanFit span = fitter.fit();
    // The loop begins where the fit does, near its first point rather than on it.
    result_.path.clear();
    result_.path.move_to(span.curves.front().p0);
    append_curves(span, false);
  }

  // From one vertex on to another; from a vertex to itself, the whole loop.
  Chain chain_between(std::size_t from, std::size_t to) const {
    const std::size_t count = polyline_.points.size();
    Chain chain{{polyline_.points[from]}, {from}};
    for (std::size_t i = from; i != to || chain.points.size() == 1;) {
      i = (i + 1) % count;
      if (polyline_.points[i] != chain.points.back()) {
        chain.points.push_back(polyline_.points[i]);
        chain.vertices.push_back(i);
      }
      if (i == to) break;
    }
    return chain;
  }

  void append_span(const Chain& chain, bool ends_in_corner) {
    if (chain.points.size() < 2) return;
    const auto deviation = deviation_from_chord(chain.points, tolerance_ / 2);
    if (deviation && !passes_inside(chain)) {
      result_.path.line_to(chain.points.back());
      result_.points.push_back(chain.vertices.back());
      result_.corners.push_back(ends_in_corner);
      result_.error = std::max(result_.error, *deviation);
      return;
    }
    std::vector<ArcSample> samples = make_samples(chain, reach_);
    const std::size_t last = samples.size() - 1;
    const LocalFitParams params = local_params(samples[last].length);
    SpanFitter fitter(std::move(samples), 0, last, params);
    fitter.pass_through(through_);
    append_curves(fitter.fit(), ends_in_corner);
  }

  // Whether a place to pass through is not an end.
  bool passes_inside(const Chain& chain) const {
    return !through_.empty() && std::any_of(chain.vertices.begin() + 1, chain.vertices.end() - 1,
                                            [&](std::size_t vertex) {
                                              return std::ranges::binary_search(through_, vertex);
                                            });
  }

  void append_curves(const SpanFit& span, bool ends_in_corner) {
    for (std::size_t i = 0; i < span.curves.size(); ++i) {
      const CubicBezier& curve = span.curves[i];
      result_.path.cubic_to(curve.p1, curve.p2, curve.p3);
      result_.points.push_back(span.ends[i]);
      result_.corners.push_back(ends_in_corner && i + 1 == span.curves.size());
    }
    result_.error = std::max(result_.error, span.error);
  }

  const Polyline& polyline_;
  std::span<const std::size_t> through_;
  double tolerance_, reach_;
  std::vector<std::size_t> corners_;
  CubicFit result_;
};

}  // namespace

CubicFit fit_cubics(const Polyline& polyline, const CubicFitParams& params,
                    std::span<const std::size_t> through) {
  validate(polyline, params);
  return PathFitter(polyline, params, through).fit();
}

}  // namespace libstyle
