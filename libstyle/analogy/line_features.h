// SPDX-License-Identifier: Apache-2.0
// What goes along a line besides its shape: its width, the pressure of the pen, its colour.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "libstyle/curves/document.h"

namespace libstyle {

enum class FeatureKind : std::uint8_t {
  kNumber,
  kLength,  // in px: it grows and shrinks with the style
  kRed,     // parts of a colour, 0 .. 255
  kGreen,
  kBlue,
  kAlpha
};

// One number along a line. The parts of a colour are four of the same name.
struct LineFeature {
  std::string name;
  FeatureKind kind = FeatureKind::kNumber;

  friend bool operator==(const LineFeature&, const LineFeature&) = default;
};

// All values along a path but "t", which says where and not what.
std::vector<LineFeature> line_features(const AlongValues& along);

// Those that all of them have, in the order of the first.
std::vector<LineFeature> common_features(std::span<const std::vector<LineFeature>> each);

// One value for each vertex; empty if the path has no such feature.
std::vector<double> feature_values(const AlongValues& along, const LineFeature& feature);

// Values between vertices as far as they can be written: parts of a colour are whole numbers.
void round_to_writable(std::vector<double>& values, const LineFeature& feature);

// Puts values, one row for each feature, in place of those of the same names, or after all others.
// Colours are rounded.
void set_features(AlongValues& along, std::span<const LineFeature> features,
                  std::span<const std::vector<double>> values);

}  // namespace libstyle
