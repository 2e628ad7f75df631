// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/correspondence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <tuple>
#include <utility>

#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {
namespace {

constexpr std::size_t kPlaces = 300;  // on each curve
constexpr int kRounds = 3;            // of pairing and moving together
constexpr double kGapCost = 1e-3;     // of a squared unit: prefers the straight pairing to steps
constexpr std::ptrdiff_t kHannReach = 9;  // 19 taps, that round off the steps of the pairing
constexpr double kLinearShare = 0.02;     // keeps the result rising

std::vector<Point> places_on(const Polyline& curve, double unit) {
  std::vector<Point> points = resample_to_count(curve, kPlaces).points;
  for (Point& p : points) p = p / unit;
  return points;
}

void move_by(std::vector<Point>& points, Vector offset) {
  for (Point& p : points) p += offset;
}

enum class Move : std::uint8_t { kBoth, kFirst, kSecond };

struct Pairing {
  std::vector<double> indices;  // the mean index on `second` for every index on `first`
  Vector mean_offset;           // from `first` to what it is paired with
};

// The pairing of least cost.
Pairing pair_places(const std::vector<Point>& first, const std::vector<Point>& second) {
  const std::size_t n = first.size(), m = second.size();
  std::vector<double> costs(n * m);
  std::vector<Move> moves(n * m, Move::kBoth);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < m; ++k) {
      double best = i == 0 && k == 0 ? 0 : HUGE_VAL;
      const auto consider = [&](Move move, double cost) {
        if (cost < best) std::tie(best, moves[i * m + k]) = std::pair(cost, move);
      };
      if (i > 0 && k > 0) consider(Move::kBoth, costs[(i - 1) * m + k - 1]);
      if (i > 0) consider(Move::kFirst, costs[(i - 1) * m + k] + kGapCost);
      if (k > 0) consider(Move::kSecond, costs[i * m + k - 1] + kGapCost);
      costs[i * m + k] = best + squared_norm(first[i] - second[k]);
    }
  }
  Pairing pairing{std::vector<double>(n, 0.0), {}};
  std::vector<double> counts(n, 0.0);
  double pairs = 0;
  for (std::size_t i = n - 1, k = m - 1;;) {
    pairing.indices[i] += static_cast<double>(k);
    counts[i] += 1;
    pairing.mean_offset += second[k] - first[i];
    pairs += 1;
    if (i == 0 && k == 0) break;
    const Move move = moves[i * m + k];
    if (move != Move::kSecond) --i;
    if (move != Move::kFirst) --k;
  }
  for (std::size_t i = 0; i < n; ++i) pairing.indices[i] /= counts[i];
  pairing.mean_offset = pairing.mean_offset / pairs;
  return pairing;
}

// Where the curves lie does not matter: the middles of their ends come together first, then what
// was paired with what.
std::vector<double> pair_wherever_they_lie(std::vector<Point> first,
                                           const std::vector<Point>& second) {
  move_by(first, (second.front() + second.back() - first.front() - first.back()) / 2);
  Pairing pairing = pair_places(first, second);
  for (int round = 1; round < kRounds; ++round) {
    move_by(first, pairing.mean_offset);
    pairing = pair_places(first, second);
  }
  return pairing.indices;
}

// A Hann window over fractions that run from 0 to 1, reflected through both ends.
std::vector<double> smoothed(const std::vector<double>& fractions) {
  const auto n = static_cast<std::ptrdiff_t>(fractions.size());
  const auto at = [&](std::ptrdiff_t i) {
    if (i < 0) return -fractions[static_cast<std::size_t>(-i)];
    if (i >= n) return 2 - fractions[static_cast<std::size_t>(2 * (n - 1) - i)];
    return fractions[static_cast<std::size_t>(i)];
  };
  std::vector<double> result(fractions.size());
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    double sum = 0, weights = 0;
    for (std::ptrdiff_t tap = -kHannReach; tap <= kHannReach; ++tap) {
      const double phase = std::numbers::pi * static_cast<double>(tap) / (kHannReach + 1);
      const double weight = 0.5 + 0.5 * std::cos(phase);
      sum += weight * at(i + tap);
      weights += weight;
    }
    result[static_cast<std::size_t>(i)] = sum / weights;
  }
  return result;
}

}  // namespace

std::vector<double> corresponding_lengths(const Polyline& filtered, const Polyline& unfiltered) {
  const double length = arc_length(unfiltered);
  const double unit = length / 20;
  std::vector<double> fractions =
      pair_wherever_they_lie(places_on(filtered, unit), places_on(unfiltered, unit));
  for (double& fraction : fractions) fraction /= static_cast<double>(kPlaces - 1);
  fractions.front() = 0;
  fractions.back() = 1;
  fractions = smoothed(fractions);

  const std::vector<double> along = cumulative_lengths(filtered);
  std::vector<double> result;
  result.reserve(along.size());
  for (const double s : along) {
    const double share = s / along.back();
    const double index = share * static_cast<double>(kPlaces - 1);
    const auto below = std::min(static_cast<std::size_t>(index), kPlaces - 2);
    const double warped =
        std::lerp(fractions[below], fractions[below + 1], index - static_cast<double>(below));
    result.push_back(length * std::lerp(warped, share, kLinearShare));
  }
  return result;
}

}  // namespace libstyle
