// SPDX-License-Identifier: Apache-2.0
// An example of waves, and records to be drawn in it.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "libstyle/analogy/example.h"
#include "libstyle/curves/document.h"
#include "libstyle/geometry/path_data.h"

namespace libstyle {

inline std::vector<ExamplePair> wavy_pairs() {
  Polyline wave;
  for (int i = 0; i <= 1600; ++i) {
    const double x = 0.25 * i;
    wave.points.push_back({x, (3 + std::sin(x / 37)) * std::sin(2 * std::numbers::pi * x / 16)});
  }
  ExamplePair pair;
  pair.filtered = with_length_parameter(wave);
  return {pair};
}

inline PathRecord path_record(std::string id, std::string_view data) {
  PathRecord record;
  record.id = std::move(id);
  record.path = parse_path_data(data);
  return record;
}

}  // namespace libstyle
