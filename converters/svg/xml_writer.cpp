// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/xml_writer.h"

#include <algorithm>
#include <cassert>

#include "converters/svg/xml_text.h"
#include "libstyle/base/number.h"

namespace libstyle::svg {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 20;

// Deeper elements are not indented further, so that nesting costs no more than a line each.
constexpr std::size_t kDeepestIndent = 20;

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
  const bool single =
      value.find('"') != std::string_view::npos && value.find('\'') == std::string_view::npos;
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
