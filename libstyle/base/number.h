// SPDX-License-Identifier: Apache-2.0
// Numbers as text: the shortest decimal that reads back as the same double.
#pragma once

#include <string>
#include <string_view>

namespace libstyle {

// Appends the shortest text that reads back as `value`: "0.1", "-3", "1e+20". Negative zero is
// written "0". `value` must be finite.
void append_number(std::string& text, double value);

// Reads a number from the front of `text` and removes it: "-12", "0.5", ".5", "5.", "1e-3", without
// a plus in front. The result is the nearest double; what is too small for a double is 0. Returns
// false, leaving `text` alone, when there is no number or no double can hold it (1e999, inf, nan).
// Independent of the locale.
bool take_number(std::string_view& text, double& value);

// The same for text from `begin` to `end`: returns the end of the number, or null.
const char* parse_number(const char* begin, const char* end, double& value);

}  // namespace libstyle
