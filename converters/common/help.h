// SPDX-License-Identifier: Apache-2.0
// The text of --help, made from the table of options.
#pragma once

#include <string>
#include <vector>

#include "converters/common/command.h"

namespace libstyle {

// `options` are those of the command and those that every program has.
std::string help_text(const Command& command, const std::vector<Option>& options);

}  // namespace libstyle
