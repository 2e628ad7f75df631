// SPDX-License-Identifier: Apache-2.0
// The value of --style of curve-analogy: WHAT=UNFILTERED:FILTERED@SCALE.
#pragma once

#include <string>
#include <string_view>

#include "libstyle/curves/selection.h"

namespace libstyle {

// Where a style is shown.
struct ExampleFiles {
  std::string unfiltered;  // empty: there is none
  std::string filtered;
  std::string scale;  // a number or "auto"
};

struct StyleOption {
  std::string what;  // as it was given
  RecordSelector part;
  ExampleFiles files;  // scale is empty where none was given
};

// "UNFILTERED:" and "@SCALE" may be left out. What follows the last @ is part of the name of the
// file if it is neither a number nor "auto". Throws UsageError.
StyleOption parse_style_option(std::string_view text);

}  // namespace libstyle
