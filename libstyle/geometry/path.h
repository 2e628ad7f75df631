// SPDX-License-Identifier: Apache-2.0
// A path: subpaths of straight lines and cubic Bezier segments, absolute.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libstyle/geometry/box.h"
#include "libstyle/geometry/point.h"
#include "libstyle/geometry/transform.h"

namespace libstyle {

// The four commands that SVG path data is normalised to.
enum class PathCommand : std::uint8_t {
  kMove,   // 1 point: starts a subpath
  kLine,   // 1 point
  kCubic,  // 3 points: two controls, then the end
  kClose   // 0 points: a line back to the start of the subpath
};

// How many points a command takes.
constexpr std::size_t point_count(PathCommand command) {
  constexpr std::size_t kCounts[] = {1, 1, 3, 0};
  return kCounts[static_cast<std::size_t>(command)];
}

// The vertices of a path are the ends of its M, L and C commands, in order; Z adds none. Values
// along a curve are arrays parallel to the vertices.
class Path {
 public:
  // Every path begins with a move; after a close comes another move.
  void move_to(Point p) { append(PathCommand::kMove, {&p, 1}); }
  void line_to(Point p) { append(PathCommand::kLine, {&p, 1}); }
  void cubic_to(Point control1, Point control2, Point end) {
    const Point points[] = {control1, control2, end};
    append(PathCommand::kCubic, points);
  }
  void close() { append(PathCommand::kClose, {}); }

  void append(const Path& other);
  // `points` are as many as the command takes.
  void append(PathCommand command, std::span<const Point> points) {
    commands_.push_back(command);
    points_.insert(points_.end(), points.begin(), points.end());
  }
  void clear();
  void reserve(std::size_t commands, std::size_t points);

  bool empty() const { return commands_.empty(); }
  std::span<const PathCommand> commands() const { return commands_; }
  std::span<const Point> points() const { return points_; }
  std::size_t vertex_count() const;
  std::vector<Point> vertices() const;

  // Moves every point, controls included.
  void transform(const Transform& target_from_source);

  // The box of all points, controls included: contains the curve, is not always tight.
  Box control_box() const;

  friend bool operator==(const Path&, const Path&) = default;

 private:
  std::vector<PathCommand> commands_;
  std::vector<Point> points_;
};

}  // namespace libstyle
