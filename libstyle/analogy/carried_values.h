// SPDX-License-Identifier: Apache-2.0
// Values along a path, such as widths, carried to the vertices of the path that replaces it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/analogy/line_features.h"
#include "libstyle/analogy/smooth_curve.h"
#include "libstyle/curves/document.h"
#include "libstyle/geometry/flatten.h"

namespace libstyle {

// Appends to `result` what `old` says, on the subpath `flat`, at so many lengths along it. `result`
// has the channels of `old`.
void append_values(AlongValues& result, const AlongValues& old, const FlattenedSubpath& flat,
                   std::span<const double> lengths);

// What the style says of its features, for all subpaths of a path.
class StyledFeatures {
 public:
  explicit StyledFeatures(std::span<const LineFeature> features)
      : features_(features), values_(features.size()) {}

  // The last subpath, drawn.
  void append(const SmoothCurve& fresh);

  // The last subpath, not drawn, or only bent: it keeps its own values, which are the last ones of
  // `along`, or gets those of the style.
  void append_kept(const AlongValues& along, const StyledCurve& kept, std::size_t vertices);

  void put(AlongValues& along) const { set_features(along, features_, values_); }

 private:
  std::span<const LineFeature> features_;
  std::vector<std::vector<double>> values_;
};

}  // namespace libstyle
