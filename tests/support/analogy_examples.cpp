// SPDX-License-Identifier: Apache-2.0
#include "tests/support/analogy_examples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/curves.h"

namespace libstyle {

Polyline wandering_wave(std::uint64_t seed, double length) {
  RandomValues random(seed);
  Polyline result;
  double phase = 0, pace = 1, size = 5;
  for (double x = 0; x <= length; x += 0.5) {
    pace += 0.02 * (1 - pace) + random.normal(0.02);
    size += 0.02 * (5 - size) + random.normal(0.1);
    phase += 2 * std::numbers::pi * 0.5 / 22 * pace;
    result.points.push_back({x, size * std::sin(phase)});
  }
  return result;
}

ExamplePair wavy_pair() {
  ExamplePair pair;
  pair.filtered.polyline = wandering_wave(11, 600);
  for (const Point p : pair.filtered.polyline.points) pair.filtered.t.push_back(p.x / 600);
  pair.unfiltered = with_length_parameter(polyline("0 0, 600 0"));
  pair.same_parameter = true;
  return pair;
}

Polyline s_curve() {
  Polyline result;
  for (int i = 0; i <= 200; ++i) {
    result.points.push_back({3.0 * i, 60 * std::sin(2 * std::numbers::pi * i / 200)});
  }
  return result;
}

Polyline egg() {
  Polyline result{{}, true};
  for (int i = 0; i < 120; ++i) {
    const double angle = 2 * std::numbers::pi * i / 120;
    result.points.push_back({(80 + 12 * std::cos(angle)) * std::cos(angle),
                             (60 + 9 * std::sin(3 * angle)) * std::sin(angle)});
  }
  return result;
}

Polyline transformed(Polyline curve, const RigidTransform& transform) {
  for (Point& p : curve.points) p = transform(p);
  return curve;
}

ExamplePair transformed(ExamplePair pair, const RigidTransform& transform) {
  pair.filtered.polyline = transformed(pair.filtered.polyline, transform);
  if (pair.unfiltered)
    pair.unfiltered->polyline = transformed(pair.unfiltered->polyline, transform);
  return pair;
}

double distance_from(const Polyline& curve, Point p) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < segment_count(curve); ++i) {
    const Point a = segment_start(curve, i), ab = segment_end(curve, i) - a;
    const double share = std::clamp(dot(p - a, ab) / squared_norm(ab), 0.0, 1.0);
    least = std::min(least, distance(p, a + share * ab));
  }
  return least;
}

ExamplePair wave_pair(double length, double phase) {
  ExamplePair pair;
  Polyline wave;
  for (double x = 0; x <= length; x += 0.25) {
    wave.points.push_back({x, 5 * std::sin(2 * std::numbers::pi * x / 20 + phase)});
  }
  pair.filtered = with_length_parameter(wave);
  pair.unfiltered = SampledCurve{Polyline{{{0, 0}, {length, 0}}, false}, {0, 1}, {}};
  return pair;
}

}  // namespace libstyle
