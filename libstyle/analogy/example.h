// SPDX-License-Identifier: Apache-2.0
// An example pair as the solver sees it: a line, and how far off that line the style draws.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/analogy/parameters.h"
#include "libstyle/analogy/sweep.h"
#include "libstyle/geometry/polyline.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {

// A and A'. same_parameter says that places with equal t belong together; otherwise which do is
// found from the shapes.
struct ExamplePair {
  std::optional<SampledCurve> unfiltered;  // left out: the filtered curve, blurred
  SampledCurve filtered;
  bool same_parameter = false;
};

// One pair. The filtered curve is a function of the length along the unfiltered one.
class ExampleLine {
 public:
  struct Sample {
    double length = 0;  // along the unfiltered curve, never falling
    Vector offset;      // from the unfiltered curve, blurred by `blur` there, in its frame
    Vector tangent;     // unit vector along the filtered curve, in the frame
    double blur = 0;    // where the style rounds a corner, px (rounded_corners.h)
  };

  // The sweep of a closed curve is closed, and the last sample is the first again, a turn later.
  ExampleLine(Sweep sweep, std::vector<Sample> samples);

  // Whether it goes on at its beginning where it ends.
  bool goes_round() const { return sweep_.closed(); }
  double length() const { return sweep_.length(); }
  const Sweep& sweep() const { return sweep_; }
  std::span<const Sample> samples() const { return samples_; }
  // Interpolated; the ends of an open line hold beyond themselves.
  Sample at(double length) const;
  // The place of the filtered curve.
  Point filtered_at(double length) const;

 private:
  Sweep sweep_;
  std::vector<Sample> samples_;
};

// All pairs of a style, cut into states: pieces of equal length along the unfiltered curves.
// Lengths are in px of the drawing: the scale is already in them.
class Example {
 public:
  // Throws Error when a curve cannot serve: no curve at all, fewer than two different points.
  Example(std::span<const ExamplePair> pairs, const CurveAnalogyParameters& parameters);

  // Half the size of a feature, along the filtered and along the unfiltered curves.
  double feature_size() const { return feature_size_; }
  double feature_along() const { return feature_along_; }
  // How far the style strays from its own mean offset: 95 % of it less than this.
  double reach() const { return reach_; }

  std::span<const ExampleLine> lines() const { return lines_; }

  double step() const { return step_; }
  std::size_t state_count() const { return starts_.size(); }
  // The line that a state belongs to, and the length along it at which the state begins.
  std::size_t line_of(std::size_t state) const { return starts_[state].line; }
  double length_of(std::size_t state) const { return starts_[state].length; }
  // Whether state + 1 continues the line.
  bool has_next(std::size_t state) const {
    return state + 1 < starts_.size() && line_of(state + 1) == line_of(state);
  }
  const ExampleLine& line(std::size_t state) const { return lines_[line_of(state)]; }

 private:
  struct Start {
    std::size_t line;
    double length;
  };

  void cut_into_states();

  double feature_size_ = 0;
  double feature_along_ = 0;
  double reach_ = 0;
  double step_ = 0;
  std::vector<ExampleLine> lines_;
  std::vector<Start> starts_;
};

}  // namespace libstyle
