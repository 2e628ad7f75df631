// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/held_costs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace libstyle {
namespace {

// How far off a line that is held a walk may be there, as a share of the reach of the style.
constexpr double kHeldSpread = 0.15;

// What it costs that no stroke is there: as a stroke four spreads off. One that goes on for so many
// feature sizes is one.
constexpr double kPenUp = 8;
constexpr double kLeastStroke = 0.6;

// Of all strokes that go on as far as `inward`.
std::vector<Vector> offsets_at(const ExampleLine& line, double length, double inward) {
  std::vector<Vector> result;
  for (const Lane& lane : line.lanes()) {
    if (!lane.is_down(length) || !lane.is_down(length + inward)) continue;
    result.push_back(lane.at(length).offset);
  }
  return result;
}

}  // namespace

HeldCosts::HeldCosts(const Example& example) : spread_(kHeldSpread * example.reach()) {
  for (std::size_t j = 0; j < example.state_count(); ++j) {
    const double start = example.length_of(j);
    const double least = kLeastStroke * example.feature_along();
    starts_.push_back(offsets_at(example.line(j), start, least));
    ends_.push_back(offsets_at(example.line(j), start + example.step(), -least));
  }
}

bool HeldCosts::add(std::size_t step, std::size_t steps, std::span<const Place> held,
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

// Of the stroke that is nearest.
double HeldCosts::cost(std::span<const Vector> strokes, Vector wanted) const {
  if (strokes.empty()) return kPenUp;
  if (!(spread_ > 0)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const Vector offset : strokes) least = std::min(least, squared_norm(offset - wanted));
  return least / (2 * spread_ * spread_);
}

}  // namespace libstyle
