// SPDX-License-Identifier: Apache-2.0
#include "tests/support/curves.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "libstyle/base/number.h"

namespace libstyle {
namespace {

double take_coordinate(std::string_view& text, std::string_view whole) {
  text.remove_prefix(std::min(text.find_first_not_of(", "), text.size()));
  double value = 0;
  if (!take_number(text, value)) {
    throw std::invalid_argument("not a polyline: " + std::string(whole));
  }
  return value;
}

Point on_circle(Point center, double radius, double angle) {
  return center + radius * Vector{std::cos(angle), std::sin(angle)};
}

}  // namespace

Polyline polyline(std::string_view text) {
  Polyline result;
  std::string_view rest = text;
  if (rest.ends_with('z')) {
    result.closed = true;
    rest.remove_suffix(1);
  }
  while (rest.find_first_not_of(", ") != std::string_view::npos) {
    const double x = take_coordinate(rest, text);
    result.points.push_back({x, take_coordinate(rest, text)});
  }
  return result;
}

Polyline arc(Point center, double radius, double from, double to, std::size_t count) {
  Polyline result;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    result.points.push_back(on_circle(center, radius, from + share * (to - from)));
  }
  return result;
}

Polyline circle(Point center, double radius, std::size_t count) {
  Polyline result{{}, true};
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    result.points.push_back(on_circle(center, radius, 2 * std::numbers::pi * share));
  }
  return result;
}

Polyline random_stroke(RandomValues& random, std::size_t count) {
  Polyline result;
  Point point{random.uniform(-10, 10), random.uniform(-10, 10)};
  double direction = random.uniform(0, 2 * std::numbers::pi), curvature = 0;
  for (std::size_t i = 0; i < count; ++i) {
    result.points.push_back(point);
    const double step = random.uniform(0.2, 1.8);
    curvature += random.normal(0.05) - 0.05 * curvature;
    direction += step * curvature;
    point = on_circle(point, step, direction);
  }
  return result;
}

Polyline random_scribble(RandomValues& random, std::size_t count, double side) {
  Polyline result;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(0, side);
    result.points.push_back({x, random.uniform(0, side)});
  }
  return result;
}

Polyline random_blob(RandomValues& random, std::size_t count) {
  constexpr std::size_t kHarmonics = 5;
  double amplitude[kHarmonics], phase[kHarmonics];
  for (std::size_t k = 0; k < kHarmonics; ++k) {
    amplitude[k] = random.uniform(0, 2.0 / static_cast<double>(k + 1));
    phase[k] = random.uniform(0, 2 * std::numbers::pi);
  }
  Polyline result{{}, true};
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    double radius = 10;
    for (std::size_t k = 0; k < kHarmonics; ++k) {
      radius += amplitude[k] * std::cos(static_cast<double>(k + 1) * angle + phase[k]);
    }
    result.points.push_back(on_circle({}, radius, angle));
  }
  return result;
}

Polyline random_lattice_walk(RandomValues& random, std::size_t count, std::size_t side) {
  Polyline result;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<double>(random.below(side));
    result.points.push_back({x, static_cast<double>(random.below(side))});
  }
  return result;
}

Polyline with_noise(Polyline curve, RandomValues& random, double deviation) {
  for (Point& point : curve.points) {
    const double x = random.normal(deviation);
    point += Vector{x, random.normal(deviation)};
  }
  return curve;
}

}  // namespace libstyle
