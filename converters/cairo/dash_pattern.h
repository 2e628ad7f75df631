// SPDX-License-Identifier: Apache-2.0
// Dash arrays as SVG understands them.
#pragma once

#include <vector>

#include "libstyle/curves/style.h"

namespace libstyle {

// Dash and gap in turn, an even number of them. Empty: solid.
struct DashPattern {
  std::vector<double> lengths;
  double period = 0;  // their sum
  double offset = 0;  // 0 .. period

  // How many pieces a line is cut into, about.
  double pieces(double length) const {
    return length / period * static_cast<double>(lengths.size());
  }
};

// More pieces than this in one path cannot be told apart, and are not drawn one by one.
constexpr double kMostDashes = 1'000'000;

// The pattern that begins `start` after the path does, with all lengths multiplied by `scale`. An
// odd array runs twice, with dash and gap exchanged; an array that is all zero, or has a negative
// number, draws solid.
DashPattern make_dash_pattern(const Style& style, double start = 0, double scale = 1);

}  // namespace libstyle
