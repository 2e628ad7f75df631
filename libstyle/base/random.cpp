// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/random.h"

#include <Random123/philox.h>

#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

namespace libstyle {
namespace {

std::uint64_t join(std::uint32_t low, std::uint32_t high) {
  return static_cast<std::uint64_t>(high) << 32 | low;
}

double to_unit_interval(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream)
    : seed_(seed), stream_(stream) {}

// One Philox block: two words of 64 bits. The counter holds place and stream, the key the seed; the
// round makes room for the retries of below().
std::uint64_t RandomStream::block(std::uint64_t index, std::uint32_t round,
                                  std::uint64_t& second) const {
  using Generator = r123::Philox4x32;
  const Generator::ctr_type counter = {
      {static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32),
       static_cast<std::uint32_t>(stream_), static_cast<std::uint32_t>(stream_ >> 32)}};
  // A counter of 128 bits is full, so a retry moves to another key: an odd multiple keeps keys of
  // different rounds apart for every seed.
  const std::uint64_t keyed = seed_ + round * 0x9E3779B97F4A7C15ull;
  const Generator::key_type key = {
      {static_cast<std::uint32_t>(keyed), static_cast<std::uint32_t>(keyed >> 32)}};
  const Generator::ctr_type words = Generator()(counter, key);
  second = join(words[2], words[3]);
  return join(words[0], words[1]);
}

std::uint64_t RandomStream::bits(std::uint64_t index) const {
  std::uint64_t second = 0;
  return block(index, 0, second);
}

double RandomStream::uniform(std::uint64_t index) const { return to_unit_interval(bits(index)); }

std::uint64_t RandomStream::below(std::uint64_t index, std::uint64_t count) const {
  assert(count > 0);
  // Reject the incomplete last multiple of `count`; the chance of even one retry is below
  // count / 2^64.
  const std::uint64_t excess = (0 - count) % count;
  for (std::uint32_t round = 0;; ++round) {
    std::uint64_t second = 0;
    const std::uint64_t word = block(index, round, second);
    if (word >= excess) return word % count;
  }
}

double RandomStream::normal(std::uint64_t index) const {
  std::uint64_t second = 0;
  const double radius_uniform = 1 - to_unit_interval(block(index, 0, second));  // in (0, 1]
  const double angle = 2 * std::numbers::pi * to_unit_interval(second);
  return std::sqrt(-2 * std::log(radius_uniform)) * std::cos(angle);
}

std::size_t RandomStream::choose(std::uint64_t index, std::span<const double> weights) const {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  assert(total > 0 && std::isfinite(total));
  double rest = uniform(index) * total;
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0) continue;
    chosen = i;  // the last positive weight catches what rounding leaves over
    if (rest < weights[i]) break;
    rest -= weights[i];
  }
  return chosen;
}

}  // namespace libstyle
