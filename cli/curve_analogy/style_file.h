// SPDX-License-Identifier: Apache-2.0
// Styles that are kept: an example and its options in one file (libstyle/analogy/style_document.h).
//
// The options of style_options() are keys of the header, under the names that they have on the
// command line: "--seed":7.
#pragma once

#include <string>

#include "cli/curve_analogy/settings.h"
#include "converters/common/session.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// --save-style. Throws Error, and UsageError for options that do not go with it.
void save_style(const Settings& settings, Session& session);

// The settings with all that a style says and the command line does not. `file` is its name in
// messages. Throws Error for an option that is none, or has a value of the wrong kind.
Settings with_kept_options(const Settings& settings, const Document& style,
                           const std::string& file);

}  // namespace libstyle
