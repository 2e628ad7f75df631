// SPDX-License-Identifier: Apache-2.0
// Points and vectors of the plane, in CSS px with y down unless said otherwise.
#pragma once

#include <cmath>

namespace libstyle {

struct Point {
  double x = 0;
  double y = 0;

  friend bool operator==(const Point&, const Point&) = default;

  Point& operator+=(Point other) {
    x += other.x;
    y += other.y;
    return *this;
  }
  Point& operator-=(Point other) {
    x -= other.x;
    y -= other.y;
    return *this;
  }
  Point& operator*=(double factor) {
    x *= factor;
    y *= factor;
    return *this;
  }
};

// The difference of two points. The same type: the algebra of curves mixes them freely.
using Vector = Point;

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator-(Point a) { return {-a.x, -a.y}; }
inline Point operator*(double factor, Point a) { return {factor * a.x, factor * a.y}; }
inline Point operator*(Point a, double factor) { return factor * a; }
inline Point operator/(Point a, double divisor) { return {a.x / divisor, a.y / divisor}; }

inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }

// The z component of the cross product: positive when b lies clockwise of a on a page with y down.
inline double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }

inline double squared_norm(Vector a) { return dot(a, a); }

// sqrt of the squares, not std::hypot: hypot differs between C libraries in the last digit.
inline double norm(Vector a) { return std::sqrt(squared_norm(a)); }

inline double distance(Point a, Point b) { return norm(b - a); }

inline Point lerp(Point a, Point b, double t) { return a + t * (b - a); }

// A unit vector along `a`, or {0, 0} for a vector of length zero.
inline Vector normalized(Vector a) {
  const double length = norm(a);
  return length > 0 ? a / length : Vector{};
}

inline bool is_finite(Point a) { return std::isfinite(a.x) && std::isfinite(a.y); }

}  // namespace libstyle
