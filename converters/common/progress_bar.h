// SPDX-License-Identifier: Apache-2.0
// How far long work is, on a terminal.
#pragma once

#include <string>

#include "libstyle/base/progress.h"

namespace libstyle {

bool stderr_is_terminal();

// A handler that redraws one line on stderr, at most ten times a second, from the first second on,
// with an estimate of the time left, and clears it at the end.
ProgressHandler make_progress_bar(const std::string& program);

}  // namespace libstyle
