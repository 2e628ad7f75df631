// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/path_data.h"

#include "libstyle/base/error.h"
#include "libstyle/base/number.h"

namespace libstyle {
namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\v'); }

class PathDataParser {
 public:
  explicit PathDataParser(std::string_view text) : text_(text), rest_(text) {}

  Path parse() {
    for (skip_space(); !rest_.empty(); skip_space()) take_command();
    return std::move(path_);
  }

 private:
  void take_command() {
    const char letter = rest_.front();
    switch (letter) {
      case 'M':
      case 'L':
      case 'C':
        rest_.remove_prefix(1);
        if (letter != 'M') require_subpath();
        take_segments(letter);
        return;
      case 'Z':
        require_subpath();
        rest_.remove_prefix(1);
        path_.close();
        in_subpath_ = false;
        return;
      default:
        fail("\"" + to_readable(letter) + "\" is not one of the commands M, L, C and Z");
    }
  }

  // The points of one command and of those that repeat it without a letter.
  void take_segments(char letter) {
    do {
      const Point first = take_point();
      if (letter == 'M') {
        path_.move_to(first);
        in_subpath_ = true;
        letter = 'L';
      } else if (letter == 'L') {
        path_.line_to(first);
      } else {
        const Point second = take_point();
        path_.cubic_to(first, second, take_point());
      }
    } while (continues_with_number());
  }

  Point take_point() {
    const double x = take_coordinate();
    return {x, take_coordinate()};
  }

  double take_coordinate() {
    skip_space();
    double value = 0;
    if (!take_number(rest_, value)) fail("a number is missing or too large for a double");
    skip_separator();
    return value;
  }

  bool continues_with_number() {
    if (after_comma_) return true;
    if (rest_.empty()) return false;
    const char c = rest_.front();
    return (c >= '0' && c <= '9') || c == '-' || c == '.';
  }

  void skip_space() {
    while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
  }

  void skip_separator() {
    skip_space();
    after_comma_ = rest_.starts_with(',');
    if (!after_comma_) return;
    rest_.remove_prefix(1);
    skip_space();
  }

  void require_subpath() const {
    if (!in_subpath_) fail("a subpath must begin with M");
  }

  static std::string to_readable(char c) {
    const bool printable = c > ' ' && c < '\x7f';
    return printable ? std::string(1, c) : "\\" + std::to_string(static_cast<unsigned char>(c));
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error("path data, character " + std::to_string(text_.size() - rest_.size() + 1) + ": " +
                what);
  }

  std::string_view text_;
  std::string_view rest_;
  Path path_;
  bool in_subpath_ = false;
  bool after_comma_ = false;
};

constexpr char kLetters[] = {'M', 'L', 'C', 'Z'};

}  // namespace

Path parse_path_data(std::string_view text) { return PathDataParser(text).parse(); }

void append_path_data(std::string& text, const Path& path) {
  const Point* point = path.points().data();
  bool first_command = true;
  for (const PathCommand command : path.commands()) {
    if (!first_command) text += ' ';
    first_command = false;
    text += kLetters[static_cast<std::size_t>(command)];
    const Point* const end = point + point_count(command);
    for (const Point* const begin = point; point != end; ++point) {
      if (point != begin) text += ' ';
      append_number(text, point->x);
      text += ' ';
      append_number(text, point->y);
    }
  }
}

std::string to_path_data(const Path& path) {
  std::string text;
  append_path_data(text, path);
  return text;
}

}  // namespace libstyle
