// SPDX-License-Identifier: Apache-2.0
// JSON texts in quotes, as the values of extras are kept.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace libstyle {

// Appends `value` in quotes, escaped where JSON asks for it. Throws Error when it is not UTF-8.
void append_json_string(std::string& text, std::string_view value);

// The text that a JSON string means. Nothing when `json` is anything else.
std::optional<std::string> parse_json_string(std::string_view json);

}  // namespace libstyle
