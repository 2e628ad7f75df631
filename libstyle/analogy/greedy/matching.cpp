// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/greedy/matching.h"

#include <algorithm>

namespace libstyle {
namespace {

// Calls position(k) and tangent(k) for the samples that both neighborhoods have.
template <class Position, class Tangent>
void for_each_common(const NeighborhoodView& a, const NeighborhoodView& b, std::size_t middle,
                     Position position, Tangent tangent) {
  const std::size_t begin = std::max(a.begin, b.begin), end = std::min(a.end, b.end);
  const auto piece = [&](std::size_t from, std::size_t to) {
    if (from < to) position(from);
    for (std::size_t k = from + 1; k < to; ++k) {
      position(k);
      tangent(k);
    }
  };
  if (b.has_middle || middle < begin || middle >= end) {
    piece(begin, end);
  } else {
    piece(begin, middle);
    piece(middle + 1, end);
  }
}

// conj(a) b
Vector turn_between(Vector a, Vector b) { return {dot(a, b), cross(a, b)}; }

}  // namespace

// The position in the middle is the origin and adds nothing; its two tangents do.
NeighborhoodSums sums_between(const NeighborhoodView& view, std::size_t begin, std::size_t end,
                              bool with_middle, std::size_t middle) {
  const auto tangents = [&](std::size_t from, std::size_t to) {
    return from < to ? view.sums[to].tangent_squares - view.sums[from].tangent_squares : 0.0;
  };
  NeighborhoodSums result;
  if (begin >= end) return result;
  result.positions = view.sums[end].positions - view.sums[begin].positions;
  result.position_squares = view.sums[end].position_squares - view.sums[begin].position_squares;
  result.tangent_squares = tangents(begin + 1, end);
  if (!with_middle) {
    result.tangent_squares -= tangents(std::max(middle, begin + 1), std::min(middle + 2, end));
  }
  return result;
}

double overlap_of(const NeighborhoodView& a, const NeighborhoodView& b,
                  const NeighborhoodShape& shape) {
  const double common =
      weight_of(shape, std::max(a.begin, b.begin), std::min(a.end, b.end), b.has_middle);
  return common / weight_of(shape, b.begin, b.end, b.has_middle);
}

Match match(const NeighborhoodView& a, const NeighborhoodView& b, const NeighborhoodShape& shape,
            double tangent_weight) {
  const std::size_t begin = std::max(a.begin, b.begin), end = std::min(a.end, b.end);
  Match result;
  if (begin >= end) return result;
  result.overlap = overlap_of(a, b, shape);
  result.weight = weight_of(shape, begin, end, b.has_middle);
  if (!(result.weight > 0)) return result;
  const std::size_t middle = shape.middle();
  const NeighborhoodSums sums_a = sums_between(a, begin, end, b.has_middle, middle);
  const NeighborhoodSums sums_b = sums_between(b, begin, end, b.has_middle, middle);
  result.mean_a = sums_a.positions / result.weight;
  result.mean_b = sums_b.positions / result.weight;
  result.squares = sums_a.position_squares + sums_b.position_squares +
                   tangent_weight * (sums_a.tangent_squares + sums_b.tangent_squares) -
                   result.weight * (squared_norm(result.mean_a) + squared_norm(result.mean_b));
  Vector position_twist, tangent_twist;
  for_each_common(
      a, b, middle,
      [&](std::size_t k) {
        position_twist += shape.weight(k) * turn_between(a.positions[k], b.positions[k]);
      },
      [&](std::size_t k) {
        tangent_twist += shape.weight(k) * turn_between(a.tangents[k], b.tangents[k]);
      });
  result.twist = position_twist + tangent_weight * tangent_twist -
                 result.weight * turn_between(result.mean_a, result.mean_b);
  return result;
}

double shape_distance(const NeighborhoodView& a, const NeighborhoodView& b, const Match& match,
                      Vector rotation, const NeighborhoodShape& shape, double tangent_weight) {
  double positions = 0, tangents = 0;
  const Vector shift = match.mean_b - turn(rotation, match.mean_a);
  for_each_common(
      a, b, shape.middle(),
      [&](std::size_t k) {
        positions +=
            shape.weight(k) * squared_norm(turn(rotation, a.positions[k]) + shift - b.positions[k]);
      },
      [&](std::size_t k) {
        tangents += shape.weight(k) * squared_norm(turn(rotation, a.tangents[k]) - b.tangents[k]);
      });
  return positions + tangent_weight * tangents;
}

}  // namespace libstyle
