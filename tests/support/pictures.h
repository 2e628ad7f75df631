// SPDX-License-Identifier: Apache-2.0
// Small pictures for tests.
#pragma once

#include <cstdint>

#include "libstyle/base/random.h"
#include "libstyle/image/image.h"

namespace libstyle::test {

// Every sample drawn at random from 0 .. 1: no two neighbourhoods are alike.
inline Image noise(int width, int height, int channels, std::uint64_t seed) {
  const RandomStream random(seed, 0);
  Image image(width, height, channels);
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    image.samples[i] = static_cast<float>(random.uniform(i));
  }
  return image;
}

inline Image flat(int width, int height, int channels, float value) {
  Image image(width, height, channels);
  for (float& sample : image.samples) sample = value;
  return image;
}

}  // namespace libstyle::test
