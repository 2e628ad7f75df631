// SPDX-License-Identifier: Apache-2.0
// JSON as text. Internal to libstyle/curves.
#pragma once

#include <string>
#include <string_view>

namespace libstyle {

// Appends `value` in quotes, escaped where JSON asks for it. Throws Error when it is not UTF-8.
void append_json_string(std::string& text, std::string_view value);

}  // namespace libstyle
