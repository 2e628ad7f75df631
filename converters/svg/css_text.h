// SPDX-License-Identifier: Apache-2.0
// The tokens of CSS that selectors and style sheets share (CSS Syntax Level 3).
#pragma once

#include <string>
#include <string_view>

#include "converters/svg/scanner.h"

namespace libstyle::svg {

// An identifier, its escapes resolved; "" and nothing taken when there is none.
std::string take_identifier(Scanner& scanner);

// A quoted string or an identifier.
std::string take_string_or_identifier(Scanner& scanner);

// After a function's name: what stands in its parentheses, which may hold others. "" when there are
// none.
std::string take_argument(Scanner& scanner);

// `text` with a space for every comment; strings are left alone.
std::string without_comments(std::string_view text);

// Where in `text`, from `begin` on, the first character of `stops` stands that is not within a
// string, parentheses, brackets or braces; the size of `text` when there is none.
std::size_t find_outside(std::string_view text, std::string_view stops, std::size_t begin);

}  // namespace libstyle::svg
