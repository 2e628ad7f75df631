// SPDX-License-Identifier: Apache-2.0
// Example pairs and lines of known shape.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "libstyle/geometry/sampled_curve.h"
#include "tests/support/curves.h"

namespace libstyle {

inline SampledCurve straight(double length, std::size_t points = 64) {
  Polyline line;
  for (std::size_t i = 0; i < points; ++i) {
    line.points.push_back({length * static_cast<double>(i) / static_cast<double>(points - 1), 0});
  }
  return with_length_parameter(line);
}

// A wave along the x axis whose height and pace wander, so that no two places are the same.
inline SampledCurve wave(double length, double wavelength, double height,
                         std::size_t points = 800) {
  Polyline line;
  for (std::size_t i = 0; i < points; ++i) {
    const double x = length * static_cast<double>(i) / static_cast<double>(points - 1);
    const double phase = 2 * std::numbers::pi * x / wavelength;
    line.points.push_back({x, height * (1 + 0.3 * std::sin(0.13 * phase)) *
                                  std::sin(phase + 0.5 * std::sin(0.31 * phase))});
  }
  // The parameter is that of the straight line below.
  SampledCurve result{line, {}, {}};
  for (const Point p : line.points) result.t.push_back(p.x / length);
  return result;
}

inline SampledCurve moved(SampledCurve curve, Vector by) {
  for (Point& p : curve.polyline.points) p += by;
  return curve;
}

inline SampledCurve turned(SampledCurve curve, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Point& p : curve.polyline.points) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  return curve;
}

inline double greatest_distance(const Polyline& a, const Polyline& b) {
  double greatest = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    greatest = std::fmax(greatest, distance(a.points[i], b.points[i]));
  }
  return greatest;
}

}  // namespace libstyle
