// SPDX-License-Identifier: Apache-2.0
// Says quickly of most places of an example that they cannot be the best match.
//
// All neighborhoods that are compared at once (of B', B and the level above) are one long complex
// vector: positions relative to their means and tangents, each times the root of its weight. The
// shape cost is then at least |a|^2 + |b|^2 - 2 |<a, b>|, whatever the rotation. Places of one
// example look alike, so their vectors lie close to a space of a few dimensions: with z the
// coordinates in an orthonormal basis of it and e the length of what sticks out,
//     |<a, b>| <= |<z_a, z_b>| + e_a e_b,
// a bound that costs 12 complex products instead of hundreds. It is computed in single precision,
// with an allowance for that: who is left is scored exactly, and nobody is lost.
//
// The basis is that of the principal components of up to 64 of the places.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "libstyle/analogy/greedy/neighborhood.h"

namespace libstyle {

struct ScreenedPlaces {
  std::vector<float> bounds;  // the shape cost of each place, common samples scaled up, is not less
  std::size_t likeliest = 0;  // the place of the least bound among those that were screened
};

// The example's neighborhoods outlive it.
class Screen {
 public:
  // One of the curves compared: its neighborhoods in the example and its weight in the cost, > 0.
  // The middle sample is left out of the comparison for B'.
  struct Part {
    const NeighborhoodTable* example = nullptr;
    double weight = 1;
    bool has_middle = true;
  };

  Screen(std::span<const Part> parts, const NeighborhoodShape& shape, double tangent_weight,
         bool rotate);
  ~Screen();
  Screen(Screen&&) noexcept;

  // `query` has one neighborhood for each part, which may be empty. Places without the whole
  // neighborhood are not screened: their bound is 0.
  void lower_bounds(std::span<const NeighborhoodView> query, ScreenedPlaces& result) const;

 private:
  class Implementation;
  std::unique_ptr<const Implementation> implementation_;
};

}  // namespace libstyle
