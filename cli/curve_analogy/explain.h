// SPDX-License-Identifier: Apache-2.0
// --explain: what was chosen for a style, and why, for people.
#pragma once

#include <string>
#include <string_view>

#include "libstyle/analogy/style_summary.h"

namespace libstyle {

struct ExplainedUse {
  bool has_fitting_scale = false;  // rather than one that was given
  bool makes_new_lines = false;    // --synthesize
};

// A line that names the style, and a table below it; without a line end.
std::string explanation(std::string_view name, const StyleSummary& summary,
                        const ExplainedUse& use);

}  // namespace libstyle
