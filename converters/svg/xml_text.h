// SPDX-License-Identifier: Apache-2.0
// Text as it stands in XML.
#pragma once

#include <string>
#include <string_view>

namespace libstyle::svg {

// Appends `value`, which is UTF-8, so that a parser reads it back. `quote` is what ends it, or 0
// for character data. Characters that XML cannot hold become U+FFFD.
void append_escaped(std::string& text, std::string_view value, char quote);

}  // namespace libstyle::svg
