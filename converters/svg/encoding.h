// SPDX-License-Identifier: Apache-2.0
// The bytes of an XML file as UTF-8.
#pragma once

#include <string>
#include <string_view>

#include "libstyle/base/warning.h"

namespace libstyle::svg {

// Reads UTF-8, UTF-16 (with a byte order mark, or told by its first character), and what is
// declared as ISO-8859, windows-125x or KOI8. A byte order mark is taken off. Bytes that are no
// characters become U+FFFD with one warning. Throws Error for text with NUL characters.
std::string to_utf8(std::string bytes, const std::string& file, const WarningHandler& warn);

// Appends one character.
void append_utf8(std::string& text, char32_t c);

// `text` with U+FFFD for every byte that is part of no character.
std::string repaired_utf8(std::string_view text);

}  // namespace libstyle::svg
