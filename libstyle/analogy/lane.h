// SPDX-License-Identifier: Apache-2.0
// A filtered curve as a function of the length along the unfiltered one; or several, one after the
// other, with the pen lifted in between.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "libstyle/geometry/point.h"

namespace libstyle {

class Lane {
 public:
  struct Sample {
    double length = 0;  // along the unfiltered curve, never falling
    Vector offset;      // from the unfiltered curve, blurred by `blur` there, in its frame
    Vector tangent;     // unit vector along the filtered curve, in the frame
    double blur = 0;    // where the style rounds a corner, px (rounded_corners.h)
  };

  // Lengths between which the pen is down.
  struct Stroke {
    double begin = -std::numeric_limits<double>::infinity();
    double end = std::numeric_limits<double>::infinity();
  };

  // The pen is never down.
  Lane() = default;
  // The pen is always down. `features` has a row for each feature, with a value for each sample.
  // With a period, the last sample is the first again, that much later.
  Lane(std::vector<Sample> samples, std::vector<std::vector<double>> features,
       std::optional<double> period = std::nullopt);

  // A stroke from the length of the first sample to that of the last, beyond all strokes before.
  void append_stroke(std::span<const Sample> samples,
                     std::span<const std::vector<double>> features);

  // Strokes that come that near to the ends of a line of this length go on beyond them: states may
  // end a little beyond their line.
  void extend_to_ends(double length, double near);

  std::span<const Stroke> strokes() const { return strokes_; }
  bool is_down(double length) const;

  std::span<const Sample> samples() const { return samples_; }
  std::span<const Sample> samples_of(std::size_t stroke) const;
  // The values of a feature at the samples.
  std::span<const double> feature(std::size_t index) const { return features_[index]; }

  // Interpolated; without a period the ends hold beyond themselves. Nothing where the pen is never
  // down.
  Sample at(double length) const;
  std::vector<double> features_at(double length) const;

 private:
  // Two samples, the same beyond the ends, and how far it is from the first to the second.
  struct Between {
    std::size_t before = 0, after = 0;
    double share = 0;
  };

  Between between(double length) const;

  std::vector<Stroke> strokes_;
  std::vector<std::size_t> first_samples_;  // of each stroke
  std::vector<Sample> samples_;
  std::vector<std::vector<double>> features_;
  std::optional<double> period_;
};

}  // namespace libstyle
