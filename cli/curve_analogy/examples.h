// SPDX-License-Identifier: Apache-2.0
// Reads what shows a style.
#pragma once

#include <string>

#include "cli/curve_analogy/settings.h"
#include "converters/common/session.h"
#include "libstyle/analogy/style_set.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// The first document of a file. Throws Error.
Document read_example(const std::string& name, Session& session);

// The styles of --filtered and --style. Throws Error, and UsageError if there is none.
StyleSet read_styles(const Settings& settings, Session& session);

}  // namespace libstyle
