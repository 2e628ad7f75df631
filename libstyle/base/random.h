// SPDX-License-Identifier: Apache-2.0
// Random numbers that depend on a seed and a place, never on the order in which they are drawn.
//
// Source: Salmon, Moraes, Dror and Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC 2011
// (Philox4x32-10, through the Random123 library). A stream is keyed by the user's seed and a
// stream number (a curve, a level, a pass); within a stream the n-th number is a pure function of
// n, so threads may draw in any order and the bytes of a result stay the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace libstyle {

class RandomStream {
 public:
  // `seed` is the user's; `stream` tells the places of one run apart.
  RandomStream(std::uint64_t seed, std::uint64_t stream);

  // 64 random bits for place `index`.
  std::uint64_t bits(std::uint64_t index) const;

  // Uniform in [0, 1), on a grid of 2^-53.
  double uniform(std::uint64_t index) const;

  // Uniform over the integers 0 .. count-1, without bias; `count` > 0.
  std::uint64_t below(std::uint64_t index, std::uint64_t count) const;

  // Normal with mean 0 and variance 1 (Box-Muller).
  double normal(std::uint64_t index) const;

  // Draws a place in `weights` with probability proportional to its weight. Weights are finite,
  // not negative, and not all zero.
  std::size_t choose(std::uint64_t index, std::span<const double> weights) const;

 private:
  std::uint64_t block(std::uint64_t index, std::uint32_t round, std::uint64_t& second) const;

  std::uint64_t seed_;
  std::uint64_t stream_;
};

}  // namespace libstyle
