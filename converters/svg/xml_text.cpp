// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/xml_text.h"

namespace libstyle::svg {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";

// What stands for a character that cannot stand for itself; empty for all others. `quote` is what
// ends the text, or 0.
std::string_view escape(char c, char quote) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return quote == '"' ? "&quot;" : std::string_view();
    case '\t':
      return "&#9;";
    case '\n':
      return "&#10;";
    case '\r':
      return "&#13;";
    default:
      return static_cast<unsigned char>(c) < 0x20 ? kReplacement : std::string_view();
  }
}

// U+FFFE and U+FFFF are the only characters beyond ASCII that XML 1.0 has no place for.
bool is_noncharacter(std::string_view rest) {
  return rest.starts_with("\xef\xbf\xbe") || rest.starts_with("\xef\xbf\xbf");
}

}  // namespace

void append_escaped(std::string& text, std::string_view value, char quote) {
  for (std::size_t at = 0; at < value.size(); ++at) {
    const std::string_view escaped = escape(value[at], quote);
    if (!escaped.empty()) {
      text += escaped;
    } else if (value[at] == '\xef' && is_noncharacter(value.substr(at))) {
      text += kReplacement;
      at += 2;
    } else {
      text += value[at];
    }
  }
}

}  // namespace libstyle::svg
