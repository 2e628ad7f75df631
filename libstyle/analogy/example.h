// SPDX-License-Identifier: Apache-2.0
// An example pair as the solver sees it: a line, and how far off that line the style draws.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/analogy/line_features.h"
#include "libstyle/analogy/parameters.h"
#include "libstyle/analogy/sweep.h"
#include "libstyle/geometry/polyline.h"
#include "libstyle/geometry/sampled_curve.h"

namespace libstyle {

// A and A'. same_parameter says that places with equal t belong together; otherwise which do is
// found from the shapes. What the channels of the filtered curve are is said by `features`, the
// same for all pairs of a style.
struct ExamplePair {
  std::optional<SampledCurve> unfiltered;  // left out: the filtered curve, blurred
  SampledCurve filtered;
  bool same_parameter = false;
  std::vector<LineFeature> features = {};
};

// One pair. The filtered curve is a function of the length along the unfiltered one, and so are its
// features.
class ExampleLine {
 public:
  struct Sample {
    double length = 0;  // along the unfiltered curve, never falling
    Vector offset;      // from the unfiltered curve, in its frame
    Vector tangent;     // unit vector along the filtered curve, in the frame
  };

  // `features` has a row for each feature, with one value for each sample.
  ExampleLine(Sweep sweep, std::vector<Sample> samples,
              std::vector<std::vector<double>> features = {});

  double length() const { return sweep_.length(); }
  const Sweep& sweep() const { return sweep_; }
  std::span<const Sample> samples() const { return samples_; }
  // Interpolated; the ends hold beyond themselves.
  Sample at(double length) const;
  std::vector<double> features_at(double length) const;
  // The values of a feature at the samples.
  std::span<const double> feature(std::size_t index) const { return features_[index]; }
  // The place of the filtered curve.
  Point filtered_at(double length) const;

 private:
  // Two samples, the same beyond the ends, and how far it is from the first to the second.
  struct Between {
    std::size_t before = 0, after = 0;
    double share = 0;
  };

  Between between(double length) const;

  Sweep sweep_;
  std::vector<Sample> samples_;
  std::vector<std::vector<double>> features_;
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
  std::vector<ExampleLine> lines_;
  std::vector<LineFeature> features_;
  std::vector<FeatureStatistics> statistics_;
  std::vector<Start> starts_;
};

}  // namespace libstyle
