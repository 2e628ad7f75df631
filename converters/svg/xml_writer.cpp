// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/xml_writer.h"

#include <algorithm>
#include <cassert>

#include "libstyle/base/number.h"

namespace libstyle::svg {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 20;

// Deeper elements are not indented further, so that nesting costs no more than a line each.
constexpr std::size_t kDeepestIndent = 20;

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

}  // namespace

void XmlWriter::begin(std::string_view element) {
  close_tag();
  begin_line();
  text_ += '<';
  text_ += element;
  open_.push_back(element);
  tag_is_open_ = true;
}

void XmlWriter::end() {
  assert(!open_.empty());
  const std::string_view element = open_.back();
  open_.pop_back();
  if (tag_is_open_) {
    text_ += "/>\n";
    tag_is_open_ = false;
  } else {
    begin_line();
    text_ += "</";
    text_ += element;
    text_ += ">\n";
  }
  flush_if_large();
}

void XmlWriter::attribute(std::string_view name, std::string_view value) {
  assert(tag_is_open_);
  text_ += ' ';
  text_ += name;
  text_ += '=';
  // JSON is easier to read between single quotes.
  const bool single = value.find('"') != value.npos && value.find('\'') == value.npos;
  const char quote = single ? '\'' : '"';
  text_ += quote;
  append_escaped(text_, value, quote);
  text_ += quote;
}

void XmlWriter::attribute(std::string_view name, double value) {
  std::string number;
  append_number(number, value);
  attribute(name, number);
}

void XmlWriter::text(std::string_view text) {
  close_tag();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    begin_line();
    append_escaped(text_, text.substr(0, end), 0);
    text_ += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

void XmlWriter::finish() {
  assert(open_.empty());
  sink_.write(text_);
  text_.clear();
}

void XmlWriter::begin_line() { text_.append(2 * std::min(open_.size(), kDeepestIndent), ' '); }

void XmlWriter::close_tag() {
  if (!tag_is_open_) return;
  text_ += ">\n";
  tag_is_open_ = false;
}

void XmlWriter::flush_if_large() {
  if (text_.size() < kPieceBytes) return;
  sink_.write(text_);
  text_.clear();
}

}  // namespace libstyle::svg
