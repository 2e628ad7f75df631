// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "converters/svg/angle.h"

namespace libstyle::svg {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// 90 degrees in the positive direction: clockwise on a page with y down.
Vector turned(Vector v, double direction) { return {-direction * v.y, direction * v.x}; }

// Appends pieces of the unit circle, seen through `page_from_unit`.
class UnitArc {
 public:
  UnitArc(Path& path, const Transform& page_from_unit, double direction)
      : path_(path), page_from_unit_(page_from_unit), direction_(direction) {}

  // From `start` over `angle` radians (not negative) to `end`, both on the unit circle; `page_end`
  // is where the last point is put.
  void append(Vector start, double angle, Vector end, Point page_end) {
    const int steps = std::max(0, static_cast<int>(std::ceil((angle / kDegree - 66) / 30)));
    Vector from = start;
    for (int i = 0; i < steps; ++i) {
      constexpr double kCosine30 = std::numbers::sqrt3 / 2;
      const Vector to = kCosine30 * from + 0.5 * turned(from, direction_);
      append_piece(from, to, page_from_unit_(to));
      from = to;
    }
    if (angle - steps * 30 * kDegree > 33 * kDegree) {
      const Vector middle = normalized(from + end);
      append_piece(from, middle, page_from_unit_(middle));
      from = middle;
    }
    append_piece(from, end, page_end);
  }

 private:
  void append_piece(Vector from, Vector to, Point page_end) {
    const double half_tangent = std::abs(cross(from, to)) / (1 + dot(from, to));
    const double quarter_tangent = half_tangent / (1 + std::sqrt(1 + half_tangent * half_tangent));
    const double length = 4.0 / 3 * quarter_tangent;
    path_.cubic_to(page_from_unit_(from + length * turned(from, direction_)),
                   page_from_unit_(to - length * turned(to, direction_)), page_end);
  }

  Path& path_;
  const Transform& page_from_unit_;
  double direction_;
};

// Whether the whole ellipse stays among the finite numbers.
bool fits(const Transform& page_from_unit) {
  const Transform& t = page_from_unit;
  return std::isfinite(2 * (std::abs(t.a) + std::abs(t.c)) + std::abs(t.e)) &&
         std::isfinite(2 * (std::abs(t.b) + std::abs(t.d)) + std::abs(t.f));
}

}  // namespace

void append_arc(Path& path, const Arc& arc) {
  if (arc.start == arc.end) return;
  double radius_x = std::abs(arc.radius_x), radius_y = std::abs(arc.radius_y);
  const Vector axis = unit_vector_at(arc.rotation_degrees);

  // Half of the chord from end to start, where the ellipse is the unit circle (F.6.5.1).
  const Vector chord = 0.5 * (arc.start - arc.end);
  Vector half = {dot(axis, chord) / radius_x, cross(axis, chord) / radius_y};
  const double half_length = norm(half);
  if (radius_x == 0 || radius_y == 0 || !(half_length > 0) || !std::isfinite(half_length)) {
    path.line_to(arc.end);
    return;
  }
  Vector center;  // from the middle of the chord (F.6.5.2)
  if (half_length < 1) {
    const double side = arc.large != arc.clockwise ? 1 : -1;
    const double offset = std::sqrt((1 - half_length) * (1 + half_length));
    center = side * offset / half_length * Vector{half.y, -half.x};
  } else {  // the radii are too small (F.6.6.3)
    half = half / half_length;
    radius_x *= half_length;
    radius_y *= half_length;
  }

  Transform page_from_unit = {
      radius_x * axis.x, radius_x * axis.y, -radius_y * axis.y, radius_y * axis.x, 0, 0};
  const Point page_center = lerp(arc.start, arc.end, 0.5) + page_from_unit.linear(center);
  page_from_unit.e = page_center.x;
  page_from_unit.f = page_center.y;
  if (!fits(page_from_unit)) {
    path.line_to(arc.end);
    return;
  }
  const double direction = arc.clockwise ? 1 : -1;
  const Vector start = half - center, end = -half - center;
  double angle = direction * std::atan2(cross(start, end), dot(start, end));
  if (angle < 0) angle += 2 * std::numbers::pi;
  UnitArc(path, page_from_unit, direction).append(start, angle, end, arc.end);
}

void append_quarter(Path& path, Point start, Point corner, Point end) {
  const Vector x = corner - end, y = corner - start;
  const Point center = start - x;
  const Transform page_from_unit = {x.x, x.y, y.x, y.y, center.x, center.y};
  UnitArc(path, page_from_unit, 1).append({1, 0}, std::numbers::pi / 2, {0, 1}, end);
}

}  // namespace libstyle::svg
