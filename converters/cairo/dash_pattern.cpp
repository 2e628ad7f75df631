// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/dash_pattern.h"

#include <cmath>

namespace libstyle {

DashPattern make_dash_pattern(const Style& style, double start, double scale) {
  DashPattern pattern;
  const std::size_t repeats = style.dash_array.size() % 2 == 1 ? 2 : 1;
  for (std::size_t i = 0; i < repeats; ++i) {
    for (const double length : style.dash_array) {
      if (length < 0) return {};
      pattern.lengths.push_back(length * scale);
      pattern.period += length * scale;
    }
  }
  if (!(pattern.period > 0) || !std::isfinite(pattern.period)) return {};
  pattern.offset = std::fmod(style.dash_offset * scale + start, pattern.period);
  if (pattern.offset < 0) pattern.offset += pattern.period;
  return pattern;
}

}  // namespace libstyle
