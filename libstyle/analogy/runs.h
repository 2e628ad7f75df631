// SPDX-License-Identifier: Apache-2.0
// The pieces of the example that a walk copies, laid along a line.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/analogy/chain.h"
#include "libstyle/analogy/example.h"
#include "libstyle/geometry/point.h"

namespace libstyle {

// A piece of the example copied in one go: steps first .. first + steps - 1 of the line are the
// states origin, origin + 1, ...
struct ChainRun {
  std::size_t first = 0;
  std::size_t steps = 0;
  ChainState origin = 0;

  friend bool operator==(const ChainRun&, const ChainRun&) = default;
};

std::vector<ChainRun> find_runs(const Example& example, std::span<const ChainState> walk);

// Style coordinates nearer to each other than this, in steps, are one place.
inline constexpr double kSamePlace = 1e-9;

// Runs as a function of the style coordinate, 0 .. steps. Half a feature size to each side of a
// jump two runs fade into each other.
class PlacedRuns {
 public:
  // Where a run lies, and which part of the example it copies.
  struct Placed {
    double begin = 0, end = 0;  // coordinates
    const ExampleLine* line = nullptr;
    double length = 0;    // along the example at `begin`
    double fade_out = 0;  // half the width of the fade into the next run

    double size() const { return end - begin; }
  };

  // Which runs meet at x, and how much of the right one there is.
  struct Blend {
    std::size_t left = 0, right = 0;
    double right_share = 0;
  };

  // `closed`: the last run leads on to the first, so all of them also lie before it, and again
  // after the last.
  PlacedRuns(const Example& example, std::span<const ChainRun> runs, std::size_t steps,
             bool closed);

  std::span<const Placed> runs() const { return placed_; }
  // The length along its example that a run copies at x; beyond the run as it would go on.
  double length_at(const Placed& run, double x) const;

  // What is said of a lane is said of a single filtered curve, too.

  // Of two runs one has all where the other has the pen up.
  Blend blend_at(double x, std::size_t lane = 0) const;
  Vector offset_at(const Blend& blend, double x, std::size_t lane = 0) const;
  double blur_at(const Blend& blend, double x, std::size_t lane = 0) const;
  // The features of the example, in its size.
  std::vector<double> features_at(const Blend& blend, double x, std::size_t lane = 0) const;

  // Coordinates from 0 to below `steps` at which the example has samples, or one run follows
  // another; rising, and never closer than kSamePlace.
  std::vector<double> sample_coordinates(double steps, std::size_t lane = 0) const;

  // Where the pen is down, from 0 to `steps`; on a closed line what passes the seam goes on beyond
  // it. Crumbs that a jump or an end has left of a stroke, shorter than `crumb`, are not there.
  std::vector<Lane::Stroke> strokes(double steps, std::size_t lane, double crumb) const;

 private:
  void add(std::span<const ChainRun> runs, double shift);
  Blend runs_at(double x) const;
  Blend fade(std::size_t left, double x) const;
  double coordinate_of(const Placed& run, double length) const {
    return run.begin + (length - run.length) / example_.step();
  }

  const Example& example_;
  bool closed_;
  std::vector<Placed> placed_;
};

}  // namespace libstyle
