// SPDX-License-Identifier: Apache-2.0
// The rotation and translation that bring one list of points closest to another.
//
// Source: the orthogonal Procrustes problem in the plane, in closed form. With points as complex
// numbers, centred on their weighted means, the best rotation is z / |z| for
// z = sum_k w_k conj(a_k) b_k, and the sum of squared distances left is
// sum w |a|^2 + sum w |b|^2 - 2 |z| (Umeyama, "Least-squares estimation of transformation
// parameters between two point patterns", IEEE PAMI 13(4), 1991, without scale). Reflections are
// never used: a mirrored curve is another curve.
//
// Cost: O(n), without trigonometric functions.
#pragma once

#include <span>

#include "libstyle/geometry/point.h"
#include "libstyle/geometry/transform.h"

namespace libstyle {

// p -> R p + translation, where R turns +x to (cosine, sine), a unit vector.
struct RigidTransform {
  double cosine = 1, sine = 0;
  Vector translation;

  friend bool operator==(const RigidTransform&, const RigidTransform&) = default;

  Vector linear(Vector v) const { return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y}; }
  Point operator()(Point p) const { return linear(p) + translation; }

  Transform to_transform() const {
    return {cosine, sine, -sine, cosine, translation.x, translation.y};
  }
};

// First `inner`, then `outer`.
inline RigidTransform operator*(const RigidTransform& outer, const RigidTransform& inner) {
  const Vector x = outer.linear({inner.cosine, inner.sine});
  return {x.x, x.y, outer(inner.translation)};
}

inline RigidTransform inverse(const RigidTransform& t) {
  const RigidTransform back{t.cosine, -t.sine, {}};
  return {t.cosine, -t.sine, -back.linear(t.translation)};
}

// The rotation about `center` that turns direction `from` to direction `to`; neither is zero.
RigidTransform rotation_between(Vector from, Vector to, Point center = {});

struct RigidAlignment {
  RigidTransform target_from_source;
  double residual = 0;  // sum of w |target_from_source(source) - target|^2, taken point by point
};

// `source` and `target` have the same length, at least 1. `weights` is empty (all 1) or has one
// value >= 0 for each point, not all 0. Where every rotation is equally good (points that coincide)
// there is none.
RigidAlignment align_rigidly(std::span<const Point> source, std::span<const Point> target,
                             std::span<const double> weights = {});

// As above, but without rotation.
RigidAlignment align_by_translation(std::span<const Point> source, std::span<const Point> target,
                                    std::span<const double> weights = {});

}  // namespace libstyle
