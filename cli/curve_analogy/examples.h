// SPDX-License-Identifier: Apache-2.0
// Reads what shows a style.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/curve_analogy/settings.h"
#include "converters/common/session.h"
#include "libstyle/analogy/style_set.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// A style from drawings or from a style file.
struct StyleSource {
  std::string file;   // in messages
  Document filtered;  // what shows how it is painted
  std::vector<ExamplePair> pairs;
  Settings settings;  // with what a style file says and the command line does not

  // Unset for "auto".
  std::optional<double> scale() const { return parse_scale(settings.scale); }
  // Throws UsageError, and Error for values that a style file brings in.
  CurveAnalogyParameters parameters() const;
  bool is_style_file = false;
};

// The style of --filtered or of --style-file. Throws Error, and UsageError if there is neither.
StyleSource read_style_source(const Settings& settings, Session& session);

// This style and those of --style. Throws Error, and UsageError if there is none.
StyleSet read_styles(const Settings& settings, Session& session);

}  // namespace libstyle
