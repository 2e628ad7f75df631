// SPDX-License-Identifier: Apache-2.0
// Paths as text: the subset of SVG path data that the curves format uses (absolute M L C Z).
#pragma once

#include <string>
#include <string_view>

#include "libstyle/geometry/path.h"

namespace libstyle {

// Reads "M0 0 L10 0 C10 5 5 10 0 10 Z". Numbers are separated by white space, one comma, or nothing
// where that is clear; a command letter may be left out where it repeats (after M, L is meant).
// Throws Error (no place) saying what is wrong and at which character: relative or other commands,
// a subpath that does not begin with M, a missing number, NaN or infinity.
Path parse_path_data(std::string_view text);

// Appends the path in the form above, with a letter for every command and shortest round-trip
// numbers: parse_path_data gives back the same path, bit for bit (but for the sign of zero).
void append_path_data(std::string& text, const Path& path);

std::string to_path_data(const Path& path);

}  // namespace libstyle
