// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/path_data.h"

#include <algorithm>
#include <utility>

#include "libstyle/base/error.h"
#include "libstyle/base/number.h"

namespace libstyle {
namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\v'); }

class PathDataParser {
 public:
  explicit PathDataParser(std::string_view text)
      : begin_(text.data()), at_(begin_), end_(begin_ + text.size()) {}

  Path parse() {
    reserve();
    for (skip_space(); at_ != end_; skip_space()) take_command();
    return std::move(path_);
  }

 private:
  // Makes room for as many points as there are pairs of spaces: exact for the format's own writer,
  // near for others.
  void reserve() {
    const auto spaces = static_cast<std::size_t>(std::count(begin_, end_, ' '));
    const auto longest = static_cast<std::size_t>(end_ - begin_) / 4;  // a point is "M0 0" at least
    const std::size_t points = std::min(spaces / 2, longest) + 1;
    path_.reserve(points, points);
  }

  void take_command() {
    const char letter = *at_;
    switch (letter) {
      case 'M':
      case 'L':
      case 'C':
        if (letter != 'M') require_subpath();
        ++at_;
        skip_space();
        take_segments(letter);
        return;
      case 'Z':
        require_subpath();
        ++at_;
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
    double value = 0;
    const char* const rest = parse_number(at_, end_, value);
    if (!rest) fail("a number is missing or too large for a double");
    at_ = rest;
    skip_separator();
    return value;
  }

  bool continues_with_number() const {
    if (after_comma_) return true;
    if (at_ == end_) return false;
    return (*at_ >= '0' && *at_ <= '9') || *at_ == '-' || *at_ == '.';
  }

  void skip_space() {
    while (at_ != end_ && is_space(*at_)) ++at_;
  }

  void skip_separator() {
    skip_space();
    after_comma_ = at_ != end_ && *at_ == ',';
    if (!after_comma_) return;
    ++at_;
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
    throw Error("path data, character " + std::to_string(at_ - begin_ + 1) + ": " + what);
  }

  const char* const begin_;
  const char* at_;
  const char* const end_;
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
