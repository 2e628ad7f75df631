// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/css_text.h"

#include <algorithm>
#include <cstdint>

namespace libstyle::svg {
namespace {

bool is_name_start(char c) {
  return (to_lower(c) >= 'a' && to_lower(c) <= 'z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool is_name(char c) { return is_name_start(c) || is_digit(c) || c == '-'; }

int hex_digit(char c) {
  if (is_digit(c)) return c - '0';
  const char low = to_lower(c);
  return low >= 'a' && low <= 'f' ? low - 'a' + 10 : -1;
}

// After a backslash: one character, or up to six hex digits and a space that ends them. Characters
// beyond ASCII that are written by number are not needed by anything that is drawn: they become
// '?'.
char take_escape(Scanner& scanner) {
  if (hex_digit(scanner.peek()) < 0) {
    const char c = scanner.peek();
    if (!scanner.at_end()) scanner.advance();
    return c;
  }
  std::uint32_t code = 0;
  for (int i = 0; i < 6 && hex_digit(scanner.peek()) >= 0; ++i) {
    code = code * 16 + static_cast<std::uint32_t>(hex_digit(scanner.peek()));
    scanner.advance();
  }
  if (is_space(scanner.peek())) scanner.advance();
  return code > 0 && code < 0x80 ? static_cast<char>(code) : '?';
}

}  // namespace

std::string take_identifier(Scanner& scanner) {
  std::string name;
  const Scanner before = scanner;
  while (scanner.take('-')) name += '-';
  if (!is_name_start(scanner.peek()) && scanner.peek() != '\\') {
    scanner = before;
    return {};
  }
  while (is_name(scanner.peek()) || scanner.peek() == '\\') {
    if (scanner.take('\\')) {
      name += take_escape(scanner);
    } else {
      name += scanner.peek();
      scanner.advance();
    }
  }
  return name;
}

std::string take_string_or_identifier(Scanner& scanner) {
  const char quote = scanner.peek();
  if (quote != '"' && quote != '\'') return take_identifier(scanner);
  scanner.advance();
  std::string value;
  while (!scanner.at_end() && !scanner.take(quote)) {
    if (scanner.take('\\')) {
      value += take_escape(scanner);
    } else {
      value += scanner.peek();
      scanner.advance();
    }
  }
  return value;
}

std::string take_argument(Scanner& scanner) {
  std::string argument;
  if (!scanner.take('(')) return argument;
  for (int depth = 1; !scanner.at_end(); scanner.advance()) {
    if (scanner.peek() == '(') ++depth;
    if (scanner.peek() == ')' && --depth == 0) break;
    argument += scanner.peek();
  }
  scanner.take(')');
  return argument;
}

std::string without_comments(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  char quote = '\0';
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quote == '\0' && text.substr(i, 2) == "/*") {
      const std::size_t end = text.find("*/", i + 2);
      result += ' ';
      if (end == std::string_view::npos) break;
      i = end + 1;
      continue;
    }
    if (text[i] == quote) {
      quote = '\0';
    } else if (quote == '\0' && (text[i] == '"' || text[i] == '\'')) {
      quote = text[i];
    }
    result += text[i];
  }
  return result;
}

std::size_t find_outside(std::string_view text, std::string_view stops, std::size_t begin) {
  std::size_t depth = 0;
  char quote = '\0';
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\\') {
      ++i;
    } else if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (depth == 0 && stops.find(c) != std::string_view::npos) {
      return i;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '(' || c == '[' || c == '{') {
      ++depth;
    } else if ((c == ')' || c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return text.size();
}

}  // namespace libstyle::svg
