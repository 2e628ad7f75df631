// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/path_segments.h"

#include <span>
#include <utility>

namespace libstyle {
namespace {

// Reads a path command by command.
class SubpathReader {
 public:
  void read(PathCommand command, std::span<const Point> points) {
    switch (command) {
      case PathCommand::kMove:
        subpaths_.push_back({{}, vertex_count_, false});
        start_ = current_ = points[0];
        current_vertex_ = vertex_count_++;
        break;
      case PathCommand::kLine:
        add(straight_bezier(current_, points[0]), true, vertex_count_++);
        break;
      case PathCommand::kCubic:
        add({current_, points[0], points[1], points[2]}, false, vertex_count_++);
        break;
      case PathCommand::kClose:
        if (current_ != start_) {
          add(straight_bezier(current_, start_), true, subpaths_.back().first_vertex);
        }
        subpaths_.back().closed = true;
        break;
    }
  }

  std::vector<Subpath> take() { return std::move(subpaths_); }

 private:
  void add(const CubicBezier& curve, bool straight, std::size_t end_vertex) {
    subpaths_.back().segments.push_back({curve, straight, current_vertex_, end_vertex});
    current_ = curve.p3;
    current_vertex_ = end_vertex;
  }

  std::vector<Subpath> subpaths_;
  Point start_, current_;
  std::size_t current_vertex_ = 0, vertex_count_ = 0;
};

}  // namespace

std::vector<Subpath> subpaths(const Path& path) {
  SubpathReader reader;
  std::size_t next = 0;
  for (const PathCommand command : path.commands()) {
    reader.read(command, path.points().subspan(next, point_count(command)));
    next += point_count(command);
  }
  return reader.take();
}

Box bounding_box(const Path& path) {
  Box box;
  std::size_t next = 0;
  for (const PathCommand command : path.commands()) {
    const std::size_t count = point_count(command);
    if (count > 0) box.include(path.points()[next + count - 1]);
    if (command == PathCommand::kCubic) {
      const auto points = path.points().subspan(next - 1, 4);
      box.include(bounding_box(CubicBezier{points[0], points[1], points[2], points[3]}));
    }
    next += count;
  }
  return box;
}

Path to_path(const Polyline& polyline) {
  Path path;
  path.reserve(polyline.points.size() + 1, polyline.points.size());
  for (const Point point : polyline.points) {
    if (path.empty()) {
      path.move_to(point);
    } else {
      path.line_to(point);
    }
  }
  if (polyline.closed && !path.empty()) path.close();
  return path;
}

}  // namespace libstyle
