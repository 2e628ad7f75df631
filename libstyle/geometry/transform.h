// SPDX-License-Identifier: Apache-2.0
// Affine maps of the plane, with SVG's six numbers.
#pragma once

#include <optional>

#include "libstyle/geometry/point.h"

namespace libstyle {

// (x, y) -> (a x + c y + e, b x + d y + f). Variables are named target_from_source.
struct Transform {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  friend bool operator==(const Transform&, const Transform&) = default;

  static Transform translation(Vector offset) { return {1, 0, 0, 1, offset.x, offset.y}; }
  static Transform scaling(double x, double y) { return {x, 0, 0, y, 0, 0}; }
  // Clockwise on a page with y down, in radians.
  static Transform rotation(double angle) {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return {cosine, sine, -sine, cosine, 0, 0};
  }

  Point operator()(Point p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  // As operator(), without the translation.
  Vector linear(Vector v) const { return {a * v.x + c * v.y, b * v.x + d * v.y}; }

  double determinant() const { return a * d - b * c; }

  bool is_finite() const {
    return std::isfinite(a) && std::isfinite(b) && std::isfinite(c) && std::isfinite(d) &&
           std::isfinite(e) && std::isfinite(f);
  }
};

// First `inner`, then `outer`.
inline Transform operator*(const Transform& outer, const Transform& inner) {
  const Vector x = outer.linear({inner.a, inner.b});
  const Vector y = outer.linear({inner.c, inner.d});
  const Point origin = outer({inner.e, inner.f});
  return {x.x, x.y, y.x, y.y, origin.x, origin.y};
}

// The inverse, or nothing when the map is singular or its inverse overflows.
inline std::optional<Transform> inverse(const Transform& t) {
  const double determinant = t.determinant();
  if (determinant == 0) return std::nullopt;
  Transform result{t.d / determinant, -t.b / determinant, -t.c / determinant, t.a / determinant};
  const Vector origin = result.linear({t.e, t.f});
  result.e = -origin.x;
  result.f = -origin.y;
  if (!result.is_finite()) return std::nullopt;
  return result;
}

}  // namespace libstyle
