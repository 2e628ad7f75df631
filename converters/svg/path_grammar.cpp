// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/path_grammar.h"

#include "converters/svg/arc.h"
#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

class PathParser {
 public:
  PathParser(std::string_view text, std::size_t point_limit, bool arcs_whole)
      : scanner_(text), point_limit_(point_limit), arcs_whole_(arcs_whole) {}

  ParsedPath parse() {
    scanner_.skip_spaces();
    while (!scanner_.at_end()) {
      if (!parse_command()) return {std::move(path_), scanner_.position()};
    }
    return {std::move(path_), std::nullopt};
  }

 private:
  // One letter and all segments that follow it.
  bool parse_command() {
    const char letter = scanner_.peek();
    command_ = to_lower(letter);
    relative_ = letter == command_;
    if (path_.empty() && command_ != 'm') return false;
    if (std::string_view("mlhvcsqtaz").find(command_) == std::string_view::npos) return false;
    scanner_.advance();
    scanner_.skip_spaces();
    if (command_ == 'z') return close();
    do {
      if (!parse_segment() || path_.points().size() > point_limit_) return false;
      if (command_ == 'm') command_ = 'l';
    } while (goes_on());
    return true;
  }

  // Whether the arguments of another segment follow; a comma before them belongs to them.
  bool goes_on() {
    const bool comma = scanner_.skip_separator();
    const char c = scanner_.peek();
    return comma || is_digit(c) || c == '.' || c == '-' || c == '+';
  }

  bool parse_segment() {
    switch (command_) {
      case 'm':
        return parse_move();
      case 'l':
        return parse_line();
      case 'h':
        return parse_horizontal();
      case 'v':
        return parse_vertical();
      case 'c':
        return parse_cubic();
      case 's':
        return parse_smooth_cubic();
      case 'q':
        return parse_quadratic();
      case 't':
        return parse_smooth_quadratic();
      default:
        return parse_arc();
    }
  }

  bool parse_move() {
    Point end;
    if (!take_point(end)) return false;
    path_.move_to(end);
    subpath_start_ = end;
    closed_ = false;
    stand_at(end);
    return true;
  }

  bool parse_line() {
    Point end;
    return take_point(end) && line_to(end);
  }

  bool parse_horizontal() {
    double x = 0;
    return take_coordinate(x, current_.x) && line_to({x, current_.y});
  }

  bool parse_vertical() {
    double y = 0;
    return take_coordinate(y, current_.y) && line_to({current_.x, y});
  }

  bool parse_cubic() {
    Point control1, control2, end;
    return take_point(control1) && take_next_point(control2) && take_next_point(end) &&
           cubic_to(control1, control2, end, 'c', control2);
  }

  bool parse_smooth_cubic() {
    Point control2, end;
    const Point control1 = reflected('c');
    return take_point(control2) && take_next_point(end) &&
           cubic_to(control1, control2, end, 'c', control2);
  }

  bool parse_quadratic() {
    Point control, end;
    return take_point(control) && take_next_point(end) && quadratic_to(control, end);
  }

  bool parse_smooth_quadratic() {
    Point end;
    const Point control = reflected('q');
    return take_point(end) && quadratic_to(control, end);
  }

  bool parse_arc() {
    Arc arc;
    arc.start = current_;
    if (!scanner_.take_number(arc.radius_x)) return false;
    scanner_.skip_separator();
    if (!scanner_.take_number(arc.radius_y)) return false;
    scanner_.skip_separator();
    if (!scanner_.take_number(arc.rotation_degrees)) return false;
    if (!take_flag(arc.large) || !take_flag(arc.clockwise) || !take_next_point(arc.end))
      return false;
    const bool straight = arc.radius_x == 0 || arc.radius_y == 0;
    if (straight) return line_to(arc.end);
    begin_subpath();
    if (arcs_whole_) {
      append_whole(arc);
    } else {
      append_arc(path_, arc);
    }
    stand_at(arc.end);
    return true;
  }

  void append_whole(const Arc& arc) {
    Path pieces;
    append_arc(pieces, arc);
    const auto points = pieces.points();
    if (points.size() < 3) return path_.append(pieces);
    path_.cubic_to(points.front(), points[points.size() - 2], points.back());
  }

  bool close() {
    if (!closed_) path_.close();
    closed_ = true;
    stand_at(subpath_start_);
    return true;
  }

  bool take_coordinate(double& value, double origin) {
    if (!scanner_.take_number(value)) return false;
    if (relative_) value += origin;
    return std::isfinite(value);
  }

  bool take_point(Point& point) {
    if (!take_coordinate(point.x, current_.x)) return false;
    scanner_.skip_separator();
    return take_coordinate(point.y, current_.y);
  }

  bool take_next_point(Point& point) {
    scanner_.skip_separator();
    return take_point(point);
  }

  bool take_flag(bool& flag) {
    scanner_.skip_separator();
    flag = scanner_.peek() == '1';
    return scanner_.take(flag ? '1' : '0');
  }

  // The control point for a smooth continuation: the last one turned about the current point if the
  // last segment was of the same kind ('c' or 'q').
  Point reflected(char kind) const {
    return control_kind_ == kind ? 2 * current_ - control_ : current_;
  }

  bool line_to(Point end) {
    begin_subpath();
    path_.line_to(end);
    stand_at(end);
    return true;
  }

  bool quadratic_to(Point control, Point end) {
    return cubic_to(lerp(current_, control, 2.0 / 3), lerp(end, control, 2.0 / 3), end, 'q',
                    control);
  }

  // `kind` and `control` are what a smooth continuation starts from. Controls are made by sums that
  // may overflow.
  bool cubic_to(Point control1, Point control2, Point end, char kind, Point control) {
    if (!is_finite(control1) || !is_finite(control2)) return false;
    begin_subpath();
    path_.cubic_to(control1, control2, end);
    stand_at(end);
    control_ = control;
    control_kind_ = kind;
    return true;
  }

  void begin_subpath() {
    if (!closed_) return;
    path_.move_to(subpath_start_);
    closed_ = false;
  }

  void stand_at(Point point) {
    current_ = point;
    control_kind_ = 0;
  }

  Scanner scanner_;
  std::size_t point_limit_;
  bool arcs_whole_;  // one cubic for each arc
  Path path_;
  char command_ = 0;  // in lower case
  bool relative_ = false;
  bool closed_ = false;  // the last command was Z
  Point subpath_start_;
  Point current_;
  Point control_;          // the last control point,
  char control_kind_ = 0;  // of a 'c'ubic or a 'q'uadratic, if that was the last segment
};

}  // namespace

ParsedPath parse_path_grammar(std::string_view text, std::size_t point_limit) {
  return PathParser(text, point_limit, false).parse();
}

Path parse_path_vertices(std::string_view text) {
  return PathParser(text, std::numeric_limits<std::size_t>::max(), true).parse().path;
}

}  // namespace libstyle::svg
