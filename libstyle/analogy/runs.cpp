// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/runs.h"

#include <algorithm>
#include <cmath>

namespace libstyle {
namespace {

constexpr double kFade = 0.5;  // feature sizes to each side of a jump

}  // namespace

std::vector<ChainRun> find_runs(const Example& example, std::span<const ChainState> walk) {
  std::vector<ChainRun> runs;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const bool goes_on = i > 0 && walk[i] == walk[i - 1] + 1 && example.has_next(walk[i - 1]);
    if (!goes_on) runs.push_back({i, 0, walk[i]});
    ++runs.back().steps;
  }
  return runs;
}

PlacedRuns::PlacedRuns(const Example& example, std::span<const ChainRun> runs, std::size_t steps,
                       bool closed)
    : example_(example), closed_(closed) {
  const auto total = static_cast<double>(steps);
  if (closed) add(runs, -total);
  add(runs, 0);
  if (closed) add(runs, total);
  const double fade = kFade * example.feature_along() / example.step();
  for (std::size_t i = 0; i + 1 < placed_.size(); ++i) {
    placed_[i].fade_out = std::min({fade, placed_[i].size() / 2, placed_[i + 1].size() / 2});
  }
}

void PlacedRuns::add(std::span<const ChainRun> runs, double shift) {
  for (const ChainRun& run : runs) {
    const double begin = static_cast<double>(run.first) + shift;
    placed_.push_back({begin, begin + static_cast<double>(run.steps), &example_.line(run.origin),
                       example_.length_of(run.origin)});
  }
}

double PlacedRuns::length_at(const Placed& run, double x) const {
  return run.length + (x - run.begin) * example_.step();
}

PlacedRuns::Blend PlacedRuns::blend_at(double x, std::size_t lane) const {
  Blend blend = runs_at(x);
  const auto is_down = [&](const Placed& run) {
    return run.line->lane(lane).is_down(length_at(run, x));
  };
  if (blend.left == blend.right) return blend;
  if (!is_down(placed_[blend.right])) return {blend.left, blend.left, 0};
  if (!is_down(placed_[blend.left])) return {blend.right, blend.right, 0};
  return blend;
}

PlacedRuns::Blend PlacedRuns::runs_at(double x) const {
  const auto next = std::ranges::upper_bound(placed_, x, {}, &Placed::begin);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, next - placed_.begin() - 1));
  if (i > 0 && x - placed_[i].begin < placed_[i - 1].fade_out) return fade(i - 1, x);
  if (i + 1 < placed_.size() && placed_[i].end - x < placed_[i].fade_out) return fade(i, x);
  return {i, i, 0};
}

PlacedRuns::Blend PlacedRuns::fade(std::size_t left, double x) const {
  const double half = placed_[left].fade_out;
  const double u = std::clamp((x - placed_[left].end + half) / (2 * half), 0.0, 1.0);
  return {left, left + 1, u * u * (3 - 2 * u)};
}

Vector PlacedRuns::offset_at(const Blend& blend, double x, std::size_t lane) const {
  const auto offset_of = [&](const Placed& run) {
    return run.line->lane(lane).at(length_at(run, x)).offset;
  };
  const Vector left = offset_of(placed_[blend.left]);
  if (blend.left == blend.right) return left;
  return lerp(left, offset_of(placed_[blend.right]), blend.right_share);
}

std::vector<double> PlacedRuns::features_at(const Blend& blend, double x, std::size_t lane) const {
  const auto features_of = [&](const Placed& run) {
    return run.line->lane(lane).features_at(length_at(run, x));
  };
  std::vector<double> result = features_of(placed_[blend.left]);
  if (blend.left == blend.right) return result;
  const std::vector<double> right = features_of(placed_[blend.right]);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = std::lerp(result[i], right[i], blend.right_share);
  }
  return result;
}

double PlacedRuns::blur_at(const Blend& blend, double x, std::size_t lane) const {
  const auto blur_of = [&](const Placed& run) {
    return run.line->lane(lane).at(length_at(run, x)).blur;
  };
  const double left = blur_of(placed_[blend.left]);
  if (blend.left == blend.right) return left;
  return std::lerp(left, blur_of(placed_[blend.right]), blend.right_share);
}

std::vector<double> PlacedRuns::sample_coordinates(double steps, std::size_t lane) const {
  std::vector<double> result;
  for (const Placed& run : placed_) {
    if (run.end <= 0 || run.begin >= steps) continue;
    result.push_back(run.begin);
    const auto samples = run.line->lane(lane).samples();
    auto at = std::ranges::upper_bound(samples, run.length, {}, &ExampleLine::Sample::length);
    for (; at != samples.end(); ++at) {
      const double x = coordinate_of(run, at->length);
      if (x >= run.end - kSamePlace) break;
      if (x > result.back() + kSamePlace) result.push_back(x);
    }
  }
  return result;
}

std::vector<Lane::Stroke> PlacedRuns::strokes(double steps, std::size_t lane, double crumb) const {
  struct Piece {
    Lane::Stroke stroke;
    bool starts = false, ends = false;  // as the example has it, not at a jump or an end
  };
  std::vector<Piece> pieces;
  for (const Placed& run : placed_) {
    for (const Lane::Stroke& stroke : run.line->lane(lane).strokes()) {
      const double first = std::max(run.begin, 0.0), last = std::min(run.end, steps);
      const double begin = coordinate_of(run, stroke.begin), end = coordinate_of(run, stroke.end);
      Piece piece{{std::max(begin, first), std::min(end, last)}, begin >= first, end <= last};
      if (!(piece.stroke.end > piece.stroke.begin + kSamePlace)) continue;
      const bool goes_on = !pieces.empty() && !pieces.back().ends && !piece.starts &&
                           piece.stroke.begin - pieces.back().stroke.end <= kSamePlace;
      if (!goes_on) {
        pieces.push_back(piece);
      } else {
        pieces.back().stroke.end = piece.stroke.end;
        pieces.back().ends = piece.ends;
      }
    }
  }
  if (closed_ && pieces.size() > 1 && !pieces.front().starts && !pieces.back().ends &&
      pieces.front().stroke.begin == 0 && pieces.back().stroke.end == steps) {
    pieces.back().stroke.end += pieces.front().stroke.end;
    pieces.back().ends = pieces.front().ends;
    pieces.erase(pieces.begin());
  }
  std::vector<Lane::Stroke> result;
  for (const Piece& piece : pieces) {
    const bool whole = piece.starts && piece.ends;
    if (whole || piece.stroke.end - piece.stroke.begin >= crumb) result.push_back(piece.stroke);
  }
  return result;
}

}  // namespace libstyle
