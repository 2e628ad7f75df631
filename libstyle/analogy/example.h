// SPDX-License-Identifier: Apache-2.0
// An example pair as the solver sees it: a line, and how far off that line the style draws.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/analogy/lane.h"
#include "libstyle/analogy/line_features.h"
#include "libstyle/analogy/parameters.h"
#include "libstyle/analogy/sweep.h"
#include "libstyle/geometry/polyline.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {

// A and A'. same_parameter says that places with equal t belong together; otherwise which do is
// found from the shapes. What the channels of the filtered curve are is said by `features`, the
// same for all pairs of a style. Where one unfiltered curve was drawn as several strokes, `others`
// are the further ones, in any order; places are then found from where they lie.
struct ExamplePair {
  std::optional<SampledCurve> unfiltered;  // left out: the filtered curve, blurred
  SampledCurve filtered;
  bool same_parameter = false;
  std::vector<LineFeature> features = {};
  std::vector<SampledCurve> others = {};
};

// One pair. The filtered curve is a function of the length along the unfiltered one, and so are its
// features: a lane. Strokes that overlap are in several lanes.
class ExampleLine {
 public:
  using Sample = Lane::Sample;

  // At least one lane. The sweep of a closed curve is closed, and its lanes go round.
  ExampleLine(Sweep sweep, std::vector<Lane> lanes);

  // Whether it goes on at its beginning where it ends.
  bool goes_round() const { return sweep_.closed(); }
  double length() const { return sweep_.length(); }
  const Sweep& sweep() const { return sweep_; }
  const Lane& lane(std::size_t index) const { return lanes_[index]; }
  std::span<const Lane> lanes() const { return lanes_; }

  // Of the first lane, which is the filtered curve where it is a single one.
  std::span<const Sample> samples() const { return lanes_.front().samples(); }
  Sample at(double length) const { return lanes_.front().at(length); }
  // The place of the filtered curve.
  Point filtered_at(double length) const;

  // Lanes on which the pen is never down, until there are so many.
  void add_empty_lanes(std::size_t count) { lanes_.resize(std::max(count, lanes_.size())); }

 private:
  Sweep sweep_;
  std::vector<Lane> lanes_;
};

// The values of a feature in all examples of a style.
struct FeatureStatistics {
  double mean = 0;
  double spread = 0;  // standard deviation
  double extent = 0;  // how much there is to be seen: the largest length, the range of numbers
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
  // How many lanes each of them has.
  std::size_t lane_count() const { return lines_.front().lanes().size(); }
  // Whether lines are drawn as several strokes, or as broken ones.
  bool has_strokes() const { return has_strokes_; }

  std::span<const LineFeature> features() const { return features_; }
  const FeatureStatistics& statistics(std::size_t feature) const { return statistics_[feature]; }

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
  void measure_features();

  double feature_size_ = 0;
  double feature_along_ = 0;
  double reach_ = 0;
  double step_ = 0;
  bool has_strokes_ = false;
  std::vector<ExampleLine> lines_;
  std::vector<LineFeature> features_;
  std::vector<FeatureStatistics> statistics_;
  std::vector<Start> starts_;
};

}  // namespace libstyle
