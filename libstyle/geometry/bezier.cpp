// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/bezier.h"

#include <algorithm>
#include <cmath>

namespace libstyle {
namespace {

// The values of t in ]0, 1[ where a + b t + c t^2 = 0 changes sign; at most two.
struct Roots {
  double t[2];
  int count = 0;

  void add(double value) {
    if (value > 0 && value < 1) t[count++] = value;
  }
};

// By the formula that does not cancel.
Roots unit_roots(double a, double b, double c) {
  Roots roots;
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return roots;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  if (q != 0) roots.add(a / q);
  if (c != 0) roots.add(q / c);
  return roots;
}

// The parameters of the extremes of one coordinate with the given Bernstein coefficients.
Roots extremes(double p0, double p1, double p2, double p3) {
  const double a = p1 - p0, b = p2 - p1, c = p3 - p2;  // Bernstein coefficients of B' / 3
  return unit_roots(a, 2 * (b - a), a - 2 * b + c);
}

double gauss_length(const CubicBezier& curve) {
  constexpr double kPlaces[] = {0, 0.5384693101056831, 0.9061798459386640};
  constexpr double kWeights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  double sum = kWeights[0] * norm(derivative_at(curve, 0.5));
  for (int i = 1; i < 3; ++i) {
    sum += kWeights[i] * (norm(derivative_at(curve, 0.5 - 0.5 * kPlaces[i])) +
                          norm(derivative_at(curve, 0.5 + 0.5 * kPlaces[i])));
  }
  return 0.5 * sum;
}

double refined_length(const CubicBezier& curve, double length, double tolerance, int depth) {
  const auto [before, after] = split_at(curve, 0.5);
  const double first = gauss_length(before), second = gauss_length(after);
  if (depth == 0 || std::abs(first + second - length) <= tolerance) return first + second;
  return refined_length(before, first, 0.5 * tolerance, depth - 1) +
         refined_length(after, second, 0.5 * tolerance, depth - 1);
}

}  // namespace

Point point_at(const CubicBezier& curve, double t) {
  if (t == 1) return curve.p3;
  const Point a = lerp(curve.p0, curve.p1, t), b = lerp(curve.p1, curve.p2, t),
              c = lerp(curve.p2, curve.p3, t);
  return lerp(lerp(a, b, t), lerp(b, c, t), t);
}

Vector derivative_at(const CubicBezier& curve, double t) {
  const Vector a = curve.p1 - curve.p0, b = curve.p2 - curve.p1, c = curve.p3 - curve.p2;
  return 3 * lerp(lerp(a, b, t), lerp(b, c, t), t);
}

Vector second_derivative_at(const CubicBezier& curve, double t) {
  return 6 * lerp(curve.p0 - 2 * curve.p1 + curve.p2, curve.p1 - 2 * curve.p2 + curve.p3, t);
}

Vector tangent_at(const CubicBezier& curve, double t) {
  const Vector first = derivative_at(curve, t);
  if (first != Vector{}) return normalized(first);
  // Near t, B' is dt B'' or, where that vanishes as well, dt^2 / 2 B'''; dt is negative before t.
  const double side = t < 1 ? 1 : -1;
  const Vector second = second_derivative_at(curve, t);
  if (second != Vector{}) return normalized(side * second);
  return normalized(curve.p3 - 3 * curve.p2 + 3 * curve.p1 - curve.p0);
}

double curvature_at(const CubicBezier& curve, double t) {
  const Vector first = derivative_at(curve, t);
  const double speed = norm(first);
  return cross(first, second_derivative_at(curve, t)) / (speed * speed * speed);
}

std::pair<CubicBezier, CubicBezier> split_at(const CubicBezier& curve, double t) {
  const Point a = lerp(curve.p0, curve.p1, t), b = lerp(curve.p1, curve.p2, t),
              c = lerp(curve.p2, curve.p3, t);
  const Point ab = lerp(a, b, t), bc = lerp(b, c, t);
  const Point middle = t == 1 ? curve.p3 : lerp(ab, bc, t);
  return {{curve.p0, a, ab, middle}, {middle, bc, c, curve.p3}};
}

CubicBezier piece_between(const CubicBezier& curve, double t0, double t1) {
  // Blossoms of the cubic: the controls lie a third of the interval along the end tangents.
  const Point start = point_at(curve, t0), end = point_at(curve, t1);
  const double third = (t1 - t0) / 3;
  return {start, start + third * derivative_at(curve, t0), end - third * derivative_at(curve, t1),
          end};
}

CubicBezier reversed(const CubicBezier& curve) { return {curve.p3, curve.p2, curve.p1, curve.p0}; }

Box bounding_box(const CubicBezier& curve) {
  Box box;
  box.include(curve.p0);
  box.include(curve.p3);
  const Roots x = extremes(curve.p0.x, curve.p1.x, curve.p2.x, curve.p3.x);
  const Roots y = extremes(curve.p0.y, curve.p1.y, curve.p2.y, curve.p3.y);
  for (int i = 0; i < x.count; ++i) box.include(point_at(curve, x.t[i]));
  for (int i = 0; i < y.count; ++i) box.include(point_at(curve, y.t[i]));
  return box;
}

double arc_length(const CubicBezier& curve, double tolerance) {
  constexpr int kMaxDepth = 24;
  return refined_length(curve, gauss_length(curve), tolerance, kMaxDepth);
}

}  // namespace libstyle
