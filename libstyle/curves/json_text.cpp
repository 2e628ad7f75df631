// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/json_text.h"

#include <simdjson.h>

#include <algorithm>

#include "libstyle/base/error.h"

namespace libstyle {
namespace {

constexpr std::string_view kHexDigits = "0123456789abcdef";

bool is_plain(char c) { return c >= ' ' && c != '"' && c != '\\' && c != '\x7f'; }

void append_escaped(std::string& text, char c) {
  switch (c) {
    case '"':
      text += "\\\"";
      return;
    case '\\':
      text += "\\\\";
      return;
    case '\n':
      text += "\\n";
      return;
    case '\t':
      text += "\\t";
      return;
    default:
      if (static_cast<unsigned char>(c) >= ' ') {
        text += c;
        return;
      }
      text += "\\u00";
      text += kHexDigits[c >> 4];
      text += kHexDigits[c & 15];
  }
}

}  // namespace

void append_json_string(std::string& text, std::string_view value) {
  text += '"';
  // Most texts are ids and names of plain ASCII; only others are looked at more closely.
  if (std::ranges::all_of(value, is_plain)) {
    text += value;
  } else {
    if (!simdjson::validate_utf8(value)) throw Error("a text to be written is not UTF-8");
    for (const char c : value) append_escaped(text, c);
  }
  text += '"';
}

std::optional<std::string> parse_json_string(std::string_view json) {
  if (json.size() < 2 || json.front() != '"' || json.back() != '"') return std::nullopt;
  const std::string_view inside = json.substr(1, json.size() - 2);
  if (std::ranges::all_of(inside, is_plain)) return std::string(inside);
  simdjson::dom::parser parser;
  std::string_view text;
  if (parser.parse(json.data(), json.size()).get(text) != simdjson::SUCCESS) return std::nullopt;
  return std::string(text);
}

}  // namespace libstyle
