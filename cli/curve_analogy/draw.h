// SPDX-License-Identifier: Apache-2.0
// The drawings of the inputs, each curve drawn again.
#pragma once

#include "cli/curve_analogy/settings.h"
#include "converters/common/session.h"

namespace libstyle {

// Writes one document for each variant of each document read. Throws Error and UsageError.
void draw(const Settings& settings, Session& session);

}  // namespace libstyle
