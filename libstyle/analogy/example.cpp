// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/example.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libstyle/analogy/correspondence.h"
#include "libstyle/analogy/feature_size.h"
#include "libstyle/analogy/rounded_corners.h"
#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/gaussian.h"

namespace libstyle {
namespace {

constexpr double kBaseBlur = 2;                // feature sizes: makes A from A' where A is left out
constexpr double kStepsPerFeature = 4;         // finer steps draw no better, and cost
constexpr double kMostSamplesPerFeature = 40;  // short examples need no finer ones
constexpr double kLongestExample = 1e9;        // px; squares of lengths must not overflow
constexpr double kMaxStates = 2048;            // bounds the table of jumps
constexpr double kSharpTurn = 0.5;             // radians: resampling must not cut such a vertex off

// A closed curve becomes an open one that ends where it begins, which can be sampled and measured
// like any other.
SampledCurve opened(SampledCurve curve) {
  if (curve.polyline.closed && curve.size() > 0) {
    curve.polyline.points.push_back(curve.polyline.points.front());
    curve.t.push_back(curve.t.front() + 1);
  }
  curve.polyline.closed = false;
  curve.channels.clear();
  return curve;
}

Polyline closed_again(Polyline opened) {
  opened.points.pop_back();
  opened.closed = true;
  return opened;
}

struct Pair {
  Polyline filtered;
  std::optional<Polyline> unfiltered;
  std::vector<double> lengths;  // along the unfiltered curve, for each filtered vertex
  bool closed = false;          // both were, before they were opened
};

SampledCurve checked(const SampledCurve& curve, double scale, const char* which) {
  SampledCurve result = opened(curve);
  for (Point& p : result.polyline.points) {
    if (!is_finite(p)) {
      throw Error(std::string("the ") + which + " example has a coordinate that is not finite");
    }
    p *= scale;
  }
  const double length = result.size() == 0 ? 0 : arc_length(result.polyline);
  if (!(length > 0)) {
    throw Error(std::string("the ") + which +
                " example is a single point; draw a line that shows the style");
  }
  if (!(length < kLongestExample)) {
    throw Error(std::string("the ") + which +
                " example is more than a billion px long; draw it smaller, or at a smaller scale");
  }
  return result;
}

std::vector<double> lengths_at_parameters(const SampledCurve& curve,
                                          std::span<const double> parameters) {
  const ArcLength along(curve.polyline);
  std::vector<double> lengths;
  for (const double t : parameters) {
    lengths.push_back(along.length_to(place_at_parameter(curve, t)));
  }
  return lengths;
}

Pair prepare(const ExamplePair& pair, double scale) {
  const SampledCurve filtered = checked(pair.filtered, scale, "filtered");
  const bool closed = pair.filtered.polyline.closed;
  if (!pair.unfiltered) return {filtered.polyline, std::nullopt, {}, closed};
  const SampledCurve unfiltered = checked(*pair.unfiltered, scale, "unfiltered");
  return {filtered.polyline, unfiltered.polyline,
          pair.same_parameter ? lengths_at_parameters(unfiltered, filtered.t)
                              : corresponding_lengths(filtered.polyline, unfiltered.polyline),
          closed && pair.unfiltered->polyline.closed};
}

// The filtered curve, blurred.
Polyline without_detail(const Pair& pair, double blur) {
  if (!pair.closed) return gaussian_blur(pair.filtered, blur);
  Polyline plain = gaussian_blur(closed_again(pair.filtered), blur);
  plain.points.push_back(plain.points.front());
  plain.closed = false;
  return plain;
}

double total_length(std::span<const Polyline> curves) {
  double sum = 0;
  for (const Polyline& curve : curves) sum += arc_length(curve);
  return sum;
}

// The parameters of the vertices that resampling has to keep.
std::vector<double> sharp_parameters(const SampledCurve& curve) {
  std::vector<double> result;
  const std::vector<Point>& points = curve.polyline.points;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vector before = points[i] - points[i - 1], after = points[i + 1] - points[i];
    if (std::abs(std::atan2(cross(before, after), dot(before, after))) > kSharpTurn) {
      result.push_back(curve.t[i]);
    }
  }
  return result;
}

// The filtered curve, sampled evenly, with t the length along the unfiltered one.
SampledCurve sampled_filtered(const Pair& pair, double spacing) {
  SampledCurve curve{pair.filtered, pair.lengths, {}};
  curve = without_repeated_points(curve);
  return resample(curve, spacing, sharp_parameters(curve));
}

std::vector<ExampleLine::Sample> offsets_from(const Sweep& sweep, const SampledCurve& filtered,
                                              const RoundedCorners& rounded) {
  std::vector<ExampleLine::Sample> samples(filtered.size());
  const std::vector<Point>& points = filtered.polyline.points;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double length = filtered.t[i];
    const Vector frame = sweep.frame_at(length);
    const std::size_t last = points.size() - 1;
    const Point before = points[i > 0 ? i - 1 : (sweep.closed() ? last - 1 : 0)];
    const Point after = points[i < last ? i + 1 : (sweep.closed() ? 1 : last)];
    const double blur = rounded.blur_at(length);
    samples[i] = {length, to_frame(points[i] - sweep.point_at(length, blur), frame),
                  to_frame(normalized(after - before), frame), blur};
  }
  return samples;
}

double stray(std::span<const ExampleLine> lines) {
  Vector mean;
  double count = 0;
  for (const ExampleLine& line : lines) {
    for (const auto& sample : line.samples()) mean += sample.offset;
    count += static_cast<double>(line.samples().size());
  }
  mean = mean / count;
  std::vector<double> distances;
  for (const ExampleLine& line : lines) {
    for (const auto& sample : line.samples()) distances.push_back(distance(sample.offset, mean));
  }
  const auto place = static_cast<std::ptrdiff_t>(0.95 * count);
  std::nth_element(distances.begin(), distances.begin() + place, distances.end());
  return distances[static_cast<std::size_t>(place)];
}

}  // namespace

ExampleLine::ExampleLine(Sweep sweep, std::vector<Sample> samples)
    : sweep_(std::move(sweep)), samples_(std::move(samples)) {}

ExampleLine::Sample ExampleLine::at(double length) const {
  if (goes_round()) length -= std::floor(length / this->length()) * this->length();
  const auto after = std::ranges::upper_bound(samples_, length, {}, &Sample::length);
  if (after == samples_.begin()) return samples_.front();
  if (after == samples_.end()) return samples_.back();
  const Sample& a = *std::prev(after);
  const Sample& b = *after;
  const double share = (length - a.length) / (b.length - a.length);
  const Vector tangent = normalized(lerp(a.tangent, b.tangent, share));
  return {length, lerp(a.offset, b.offset, share), tangent == Vector{} ? a.tangent : tangent,
          std::lerp(a.blur, b.blur, share)};
}

Point ExampleLine::filtered_at(double length) const {
  const Sample sample = at(length);
  return sweep_.point_at(length, sample.blur) + to_page(sample.offset, sweep_.frame_at(length));
}

Example::Example(std::span<const ExamplePair> examples, const CurveAnalogyParameters& parameters) {
  if (examples.empty()) throw Error("there is no example; give at least one filtered curve");
  std::vector<Pair> pairs;
  std::vector<Polyline> filtered, unfiltered;
  for (const ExamplePair& example : examples) {
    pairs.push_back(prepare(example, parameters.scale));
    filtered.push_back(pairs.back().filtered);
    if (pairs.back().unfiltered) unfiltered.push_back(*pairs.back().unfiltered);
  }
  std::optional<double> plain_length;
  if (unfiltered.size() == filtered.size()) plain_length = total_length(unfiltered);
  feature_size_ = parameters.feature_size ? *parameters.feature_size * parameters.scale
                                          : find_feature_size(filtered, plain_length);

  const double filtered_length = total_length(filtered);
  double base_length = 0;
  for (Pair& pair : pairs) {
    if (!pair.unfiltered) {
      pair.unfiltered = without_detail(pair, kBaseBlur * feature_size_);
      pair.lengths = cumulative_lengths(*pair.unfiltered);
    }
    base_length += arc_length(*pair.unfiltered);
  }
  if (!(base_length > 0)) {
    throw Error(
        "the filtered example goes nowhere once its detail is taken away; draw it longer, "
        "or give the unfiltered example too");
  }
  feature_along_ = feature_size_ * base_length / filtered_length;
  const double spacing =
      std::max(filtered_length / parameters.samples, feature_size_ / kMostSamplesPerFeature);
  for (const Pair& pair : pairs) {
    const Polyline plain = pair.closed ? closed_again(*pair.unfiltered) : *pair.unfiltered;
    Sweep sweep(plain, parameters.smoothing * feature_along_, feature_along_,
                parameters.invariance);
    const SampledCurve samples = sampled_filtered(pair, spacing);
    const RoundedCorners rounded = parameters.shape_weight > 0
                                       ? RoundedCorners(plain, samples, feature_along_)
                                       : RoundedCorners();
    std::vector<ExampleLine::Sample> offsets = offsets_from(sweep, samples, rounded);
    lines_.emplace_back(std::move(sweep), std::move(offsets));
  }
  reach_ = stray(lines_);
  cut_into_states();
}

void Example::cut_into_states() {
  double length = 0;
  for (const ExampleLine& line : lines_) length += line.length();
  step_ = std::max(feature_along_ / kStepsPerFeature, length / kMaxStates);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    // A remainder of less than half a step is left over at the end of each line.
    const double count = std::max(1.0, std::round(lines_[i].length() / step_));
    for (double k = 0; k < count; ++k) starts_.push_back({i, k * step_});
  }
}

}  // namespace libstyle
