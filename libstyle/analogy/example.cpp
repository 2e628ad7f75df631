// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/example.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "libstyle/analogy/correspondence.h"
#include "libstyle/analogy/feature_size.h"
#include "libstyle/analogy/rounded_corners.h"
#include "libstyle/analogy/strokes.h"
#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/gaussian.h"

namespace libstyle {
namespace {

constexpr double kBaseBlur = 2;                // feature sizes: makes A from A' where A is left out
constexpr double kStepsPerFeature = 4;         // finer steps draw no better, and cost
constexpr double kMostSamplesPerFeature = 40;  // short examples need no finer ones
constexpr double kMostVertices = 100000;       // more cost time, and nothing is sampled so finely
constexpr double kLongestExample = 1e9;        // px; squares of lengths must not overflow
constexpr double kMaxStates = 2048;            // bounds the table of jumps
constexpr double kNearEnd = 0.5;               // feature sizes: of a stroke to the end of its line
constexpr double kSharpTurn = 0.5;             // radians: resampling must not cut such a vertex off

// A closed curve becomes an open one that ends where it begins, which can be sampled and measured
// like any other.
SampledCurve opened(SampledCurve curve) {
  if (curve.polyline.closed && curve.size() > 0) {
    curve.polyline.points.push_back(curve.polyline.points.front());
    curve.t.push_back(curve.t.front() + 1);
    for (std::vector<double>& values : curve.channels) values.push_back(values.front());
  }
  curve.polyline.closed = false;
  return curve;
}

Polyline closed_again(Polyline opened) {
  opened.points.pop_back();
  opened.closed = true;
  return opened;
}

struct Pair {
  std::optional<Polyline> unfiltered;
  std::vector<SampledCurve> strokes;  // t: the length along the unfiltered curve
  bool closed = false;                // both were, before they were opened
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
  return static_cast<double>(result.size()) > kMostVertices
             ? resample(result, length / kMostVertices)
             : result;
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

void scale_features(SampledCurve& curve, std::span<const LineFeature> features, double scale) {
  assert(curve.channels.size() == features.size());
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (features[i].kind != FeatureKind::kLength) continue;
    for (double& value : curve.channels[i]) value *= scale;
  }
}

// Several strokes have their places along the unfiltered curve as it was opened.
bool goes_round(const ExamplePair& pair) {
  return pair.others.empty() && pair.filtered.polyline.closed &&
         (!pair.unfiltered || pair.unfiltered->polyline.closed);
}

Pair prepare(const ExamplePair& pair, double scale) {
  Pair result;
  result.strokes.push_back(checked(pair.filtered, scale, "filtered"));
  for (const SampledCurve& other : pair.others) {
    result.strokes.push_back(checked(other, scale, "filtered"));
  }
  for (SampledCurve& stroke : result.strokes) scale_features(stroke, pair.features, scale);
  result.closed = goes_round(pair);
  if (!pair.unfiltered) return result;
  const SampledCurve unfiltered = checked(*pair.unfiltered, scale, "unfiltered");
  result.unfiltered = unfiltered.polyline;
  SampledCurve& first = result.strokes.front();
  if (!pair.others.empty()) {
    for (SampledCurve& stroke : result.strokes) {
      stroke = laid_along(std::move(stroke), unfiltered.polyline);
    }
  } else if (pair.same_parameter) {
    first.t = lengths_at_parameters(unfiltered, first.t);
  } else {
    first.t = corresponding_lengths(first.polyline, unfiltered.polyline);
  }
  return result;
}

// The filtered curve, blurred.
Polyline without_detail(const Pair& pair, double blur) {
  const Polyline& filtered = pair.strokes.front().polyline;
  if (!pair.closed) return gaussian_blur(filtered, blur);
  Polyline plain = gaussian_blur(closed_again(filtered), blur);
  plain.points.push_back(plain.points.front());
  plain.closed = false;
  return plain;
}

// How much of the unfiltered curves there is below the strokes: all of them below single ones.
double covered_length(const Pair& pair) {
  if (pair.strokes.size() == 1) return arc_length(*pair.unfiltered);
  double sum = 0;
  for (const SampledCurve& stroke : pair.strokes) sum += stroke.t.back() - stroke.t.front();
  return sum;
}

// Half the usual length from one beginning of a stroke to the next; 0 where strokes are not what
// the style is made of.
double size_of_strokes(std::span<const Pair> pairs) {
  double length = 0, strokes = 0;
  for (const Pair& pair : pairs) {
    if (pair.strokes.size() == 1) continue;
    length += arc_length(*pair.unfiltered);
    strokes += static_cast<double>(pair.strokes.size());
  }
  return strokes > 0 ? length / (2 * strokes) : 0;
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

// Strokes are features as well as what their shapes show, and these are not larger than a stroke
// has room for: straight ones show none.
double found_size(std::span<const Polyline> filtered, std::optional<double> plain_length,
                  double stroke_size) {
  const double found = find_feature_size(filtered, plain_length);
  if (stroke_size == 0) return found;
  const double room = total_length(filtered) / (4 * static_cast<double>(filtered.size()));
  return std::max(std::min(found, room), stroke_size);
}

// A stroke, sampled evenly.
SampledCurve sampled(const SampledCurve& stroke, double spacing) {
  const SampledCurve curve = without_repeated_points(stroke);
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

// How strokes become lanes.
struct LaneTask {
  const Polyline& plain;
  double spacing = 0;  // of samples
  double feature = 0;  // half the size of one, along the plain line
  bool rounds_corners = false;
};

std::vector<ExampleLine::Sample> samples_of(const Sweep& sweep, const SampledCurve& stroke,
                                            const LaneTask& task) {
  const RoundedCorners rounded =
      task.rounds_corners ? RoundedCorners(task.plain, stroke, task.feature) : RoundedCorners();
  return offsets_from(sweep, stroke, rounded);
}

std::vector<Lane> lanes_of(const Sweep& sweep, std::span<const SampledCurve> filtered,
                           const LaneTask& task) {
  std::vector<SampledCurve> strokes;
  for (const SampledCurve& stroke : filtered) strokes.push_back(sampled(stroke, task.spacing));
  if (strokes.size() == 1) {
    std::optional<double> period;
    if (sweep.closed()) period = sweep.length();
    return {{samples_of(sweep, strokes[0], task), strokes[0].channels, period}};
  }
  std::ranges::stable_sort(strokes, {}, [](const SampledCurve& s) { return s.t.front(); });
  std::vector<Lane::Stroke> stretches;
  for (const SampledCurve& stroke : strokes)
    stretches.push_back({stroke.t.front(), stroke.t.back()});
  const std::vector<std::size_t> places = assign_lanes(stretches);
  std::vector<Lane> lanes(std::ranges::max(places) + 1);
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    lanes[places[i]].append_stroke(samples_of(sweep, strokes[i], task), strokes[i].channels);
  }
  for (Lane& lane : lanes) lane.extend_to_ends(sweep.length(), kNearEnd * task.feature);
  return lanes;
}

double stray(std::span<const ExampleLine> lines) {
  Vector mean;
  double count = 0;
  for (const ExampleLine& line : lines) {
    for (const Lane& lane : line.lanes()) {
      for (const auto& sample : lane.samples()) mean += sample.offset;
      count += static_cast<double>(lane.samples().size());
    }
  }
  mean = mean / count;
  std::vector<double> distances;
  for (const ExampleLine& line : lines) {
    for (const Lane& lane : line.lanes()) {
      for (const auto& sample : lane.samples()) distances.push_back(distance(sample.offset, mean));
    }
  }
  const auto place = static_cast<std::ptrdiff_t>(0.95 * count);
  std::nth_element(distances.begin(), distances.begin() + place, distances.end());
  return distances[static_cast<std::size_t>(place)];
}

std::vector<double> values_of(std::span<const ExampleLine> lines, std::size_t feature) {
  std::vector<double> result;
  for (const ExampleLine& line : lines) {
    for (const Lane& lane : line.lanes()) {
      if (lane.strokes().empty()) continue;
      const std::span<const double> values = lane.feature(feature);
      result.insert(result.end(), values.begin(), values.end());
    }
  }
  return result;
}

}  // namespace

ExampleLine::ExampleLine(Sweep sweep, std::vector<Lane> lanes)
    : sweep_(std::move(sweep)), lanes_(std::move(lanes)) {}

Point ExampleLine::filtered_at(double length) const {
  const Sample sample = at(length);
  return sweep_.point_at(length, sample.blur) + to_page(sample.offset, sweep_.frame_at(length));
}

Example::Example(std::span<const ExamplePair> examples, const CurveAnalogyParameters& parameters) {
  if (examples.empty()) throw Error("there is no example; give at least one filtered curve");
  std::vector<Pair> pairs;
  std::vector<Polyline> filtered;
  std::optional<double> plain_length = 0;
  for (const ExamplePair& example : examples) {
    pairs.push_back(prepare(example, parameters.scale));
    for (const SampledCurve& stroke : pairs.back().strokes) filtered.push_back(stroke.polyline);
    has_strokes_ = has_strokes_ || !example.others.empty();
    if (!example.unfiltered) plain_length.reset();
    if (plain_length) *plain_length += covered_length(pairs.back());
  }
  const double stroke_size = parameters.feature_size ? 0 : size_of_strokes(pairs);
  feature_size_ = parameters.feature_size ? *parameters.feature_size * parameters.scale
                                          : found_size(filtered, plain_length, stroke_size);

  const double filtered_length = total_length(filtered);
  double base_length = 0;
  for (Pair& pair : pairs) {
    if (!pair.unfiltered) {
      pair.unfiltered = without_detail(pair, kBaseBlur * feature_size_);
      pair.strokes.front().t = cumulative_lengths(*pair.unfiltered);
    }
    base_length += covered_length(pair);
  }
  if (!(base_length > 0)) {
    throw Error(
        "the filtered example goes nowhere once its detail is taken away; draw it longer, "
        "or give the unfiltered example too");
  }
  feature_along_ = std::max(feature_size_ * base_length / filtered_length, stroke_size);
  const double spacing =
      std::max(filtered_length / parameters.samples, feature_size_ / kMostSamplesPerFeature);
  const bool rounds_corners = parameters.shape_weight > 0;
  std::size_t lane_count = 1;
  for (const Pair& pair : pairs) {
    const Polyline plain = pair.closed ? closed_again(*pair.unfiltered) : *pair.unfiltered;
    Sweep sweep(plain, parameters.smoothing * feature_along_, feature_along_,
                parameters.invariance);
    std::vector<Lane> lanes =
        lanes_of(sweep, pair.strokes, {plain, spacing, feature_along_, rounds_corners});
    lane_count = std::max(lane_count, lanes.size());
    lines_.emplace_back(std::move(sweep), std::move(lanes));
  }
  for (ExampleLine& line : lines_) line.add_empty_lanes(lane_count);
  reach_ = stray(lines_);
  features_ = examples.front().features;
  measure_features();
  cut_into_states();
}

void Example::measure_features() {
  for (std::size_t feature = 0; feature < features_.size(); ++feature) {
    double sum = 0, squares = 0, count = 0, low = HUGE_VAL, high = -HUGE_VAL;
    for (const double value : values_of(lines_, feature)) {
      sum += value;
      squares += value * value;
      count += 1;
      low = std::min(low, value);
      high = std::max(high, value);
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
