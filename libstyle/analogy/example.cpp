// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/example.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "libstyle/analogy/correspondence.h"
#include "libstyle/analogy/feature_size.h"
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

// A closed curve becomes an open one that ends where it begins.
SampledCurve opened(SampledCurve curve) {
  if (curve.polyline.closed && curve.size() > 0) {
    curve.polyline.points.push_back(curve.polyline.points.front());
    curve.t.push_back(curve.t.front() + 1);
    for (std::vector<double>& values : curve.channels) values.push_back(values.front());
  }
  curve.polyline.closed = false;
  return curve;
}

struct Pair {
  Polyline filtered;
  std::optional<Polyline> unfiltered;
  std::vector<double> lengths;  // along the unfiltered curve, for each filtered vertex
  std::vector<std::vector<double>> features;
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

std::vector<std::vector<double>> scaled_features(std::vector<std::vector<double>> values,
                                                 std::span<const LineFeature> features,
                                                 double scale) {
  assert(values.size() == features.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (features[i].kind != FeatureKind::kLength) continue;
    for (double& value : values[i]) value *= scale;
  }
  return values;
}

Pair prepare(const ExamplePair& pair, double scale) {
  const SampledCurve filtered = checked(pair.filtered, scale, "filtered");
  std::vector<std::vector<double>> features =
      scaled_features(filtered.channels, pair.features, scale);
  if (!pair.unfiltered) return {filtered.polyline, std::nullopt, {}, std::move(features)};
  const SampledCurve unfiltered = checked(*pair.unfiltered, scale, "unfiltered");
  return {filtered.polyline, unfiltered.polyline,
          pair.same_parameter ? lengths_at_parameters(unfiltered, filtered.t)
                              : corresponding_lengths(filtered.polyline, unfiltered.polyline),
          std::move(features)};
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
  SampledCurve curve{pair.filtered, pair.lengths, pair.features};
  curve = without_repeated_points(curve);
  return resample(curve, spacing, sharp_parameters(curve));
}

std::vector<ExampleLine::Sample> offsets_from(const Sweep& sweep, const SampledCurve& filtered) {
  std::vector<ExampleLine::Sample> samples(filtered.size());
  const std::vector<Point>& points = filtered.polyline.points;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double length = filtered.t[i];
    const Vector frame = sweep.frame_at(length);
    const Point before = points[i > 0 ? i - 1 : 0];
    const Point after = points[std::min(i + 1, points.size() - 1)];
    samples[i] = {length, to_frame(points[i] - sweep.point_at(length), frame),
                  to_frame(normalized(after - before), frame)};
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

ExampleLine::ExampleLine(Sweep sweep, std::vector<Sample> samples,
                         std::vector<std::vector<double>> features)
    : sweep_(std::move(sweep)), samples_(std::move(samples)), features_(std::move(features)) {}

ExampleLine::Between ExampleLine::between(double length) const {
  const auto above = std::ranges::upper_bound(samples_, length, {}, &Sample::length);
  const auto after = static_cast<std::size_t>(above - samples_.begin());
  if (after == 0) return {0, 0, 0};
  if (after == samples_.size()) return {after - 1, after - 1, 0};
  const double start = samples_[after - 1].length, end = samples_[after].length;
  return {after - 1, after, (length - start) / (end - start)};
}

ExampleLine::Sample ExampleLine::at(double length) const {
  const auto [before, after, share] = between(length);
  if (before == after) return samples_[before];
  const Sample &a = samples_[before], &b = samples_[after];
  const Vector tangent = normalized(lerp(a.tangent, b.tangent, share));
  return {length, lerp(a.offset, b.offset, share), tangent == Vector{} ? a.tangent : tangent};
}

std::vector<double> ExampleLine::features_at(double length) const {
  if (features_.empty()) return {};
  const auto [before, after, share] = between(length);
  std::vector<double> result;
  for (const std::vector<double>& values : features_) {
    result.push_back(std::lerp(values[before], values[after], share));
  }
  return result;
}

Point ExampleLine::filtered_at(double length) const {
  return sweep_.point_at(length) + to_page(at(length).offset, sweep_.frame_at(length));
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
      pair.unfiltered = gaussian_blur(pair.filtered, kBaseBlur * feature_size_);
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
    Sweep sweep(*pair.unfiltered, parameters.smoothing * feature_along_, feature_along_,
                parameters.invariance);
    const SampledCurve samples = sampled_filtered(pair, spacing);
    std::vector<ExampleLine::Sample> offsets = offsets_from(sweep, samples);
    lines_.emplace_back(std::move(sweep), std::move(offsets), samples.channels);
  }
  reach_ = stray(lines_);
  features_ = examples.front().features;
  measure_features();
  cut_into_states();
}

void Example::measure_features() {
  for (std::size_t feature = 0; feature < features_.size(); ++feature) {
    double sum = 0, squares = 0, count = 0, low = HUGE_VAL, high = -HUGE_VAL;
    for (const ExampleLine& line : lines_) {
      for (const double value : line.feature(feature)) {
        sum += value;
        squares += value * value;
        count += 1;
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
    const double mean = sum / count;
    const double variance = high > low ? std::max(0.0, squares / count - mean * mean) : 0;
    const bool is_length = features_[feature].kind == FeatureKind::kLength;
    statistics_.push_back({mean, std::sqrt(variance), is_length ? high : high - low});
  }
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
