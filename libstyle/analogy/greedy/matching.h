// SPDX-License-Identifier: Apache-2.0
// How well one neighborhood can be laid over another.
//
// Section 3.1 of the paper: d = min over R, t of
//     sum_k w_k (|R a_k + t - b_k|^2 + w_delta |R da_k - db_k|^2).
// With points as complex numbers and positions relative to their means, the best t brings the means
// together, and what is left is
//     |a|^2 + |b|^2 - 2 Re(conj(R) S),   S = sum w conj(a) b over positions and tangents,
// least for R = S / |S|. Several pairs of curves that share R add their S.
//
// Only samples that both neighborhoods have are compared (a tangent: both its samples).
#pragma once

#include "libstyle/analogy/greedy/neighborhood.h"

namespace libstyle {

// A rotation as the unit vector it turns {1, 0} to: complex multiplication.
inline Vector turn(Vector rotation, Vector v) {
  return {rotation.x * v.x - rotation.y * v.y, rotation.y * v.x + rotation.x * v.y};
}

// R for S; none where every rotation is equally good, or none is allowed.
inline Vector best_rotation(Vector twist, bool rotate) {
  const Vector direction = rotate ? normalized(twist) : Vector{};
  return direction == Vector{} ? Vector{1, 0} : direction;
}

// The sums over those of the samples [begin, end) that a neighborhood and another one, which may
// lack its middle, have in common; both have all of them.
NeighborhoodSums sums_between(const NeighborhoodView& view, std::size_t begin, std::size_t end,
                              bool with_middle, std::size_t middle);

struct Match {
  double overlap = 0;    // the weight of the common samples over that of all samples of b
  double weight = 0;     // of the common samples
  Point mean_a, mean_b;  // of the common samples, relative to the origins
  double squares = 0;    // |a|^2 + |b|^2
  Vector twist;          // S

  // Makes the common samples count as much as all samples of b would.
  double scale() const { return 1 / overlap; }
  // In closed form: exact to about 1e-15 of `squares`.
  double distance_for(Vector rotation) const {
    return squares - 2 * (rotation.x * twist.x + rotation.y * twist.y);
  }
};

// The overlap alone, in no time.
double overlap_of(const NeighborhoodView& a, const NeighborhoodView& b,
                  const NeighborhoodShape& shape);

// `b` may lack its middle, `a` has it.
Match match(const NeighborhoodView& a, const NeighborhoodView& b, const NeighborhoodShape& shape,
            double tangent_weight);

// The distance, sample by sample: exact where it is small.
double shape_distance(const NeighborhoodView& a, const NeighborhoodView& b, const Match& match,
                      Vector rotation, const NeighborhoodShape& shape, double tangent_weight);

}  // namespace libstyle
