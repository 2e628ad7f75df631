// SPDX-License-Identifier: Apache-2.0
// --synthesize: a curve from the example alone.
#pragma once

#include "cli/curve_analogy/settings.h"
#include "converters/common/session.h"

namespace libstyle {

// Writes one document for each variant. Throws Error, and UsageError for options that do not go
// with it.
void synthesize(const Settings& settings, Session& session);

}  // namespace libstyle
