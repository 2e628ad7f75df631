// SPDX-License-Identifier: Apache-2.0
#include "libstyle/geometry/path.h"

#include <algorithm>

namespace libstyle {

void Path::append(const Path& other) {
  commands_.insert(commands_.end(), other.commands_.begin(), other.commands_.end());
  points_.insert(points_.end(), other.points_.begin(), other.points_.end());
}

void Path::clear() {
  commands_.clear();
  points_.clear();
}

void Path::reserve(std::size_t commands, std::size_t points) {
  commands_.reserve(commands);
  points_.reserve(points);
}

std::size_t Path::vertex_count() const {
  return commands_.size() -
         static_cast<std::size_t>(std::ranges::count(commands_, PathCommand::kClose));
}

std::vector<Point> Path::vertices() const {
  std::vector<Point> result;
  std::size_t next = 0;
  for (const PathCommand command : commands_) {
    next += point_count(command);
    if (command != PathCommand::kClose) result.push_back(points_[next - 1]);
  }
  return result;
}

void Path::transform(const Transform& target_from_source) {
  for (Point& point : points_) point = target_from_source(point);
}

Box Path::control_box() const {
  Box box;
  for (const Point& point : points_) box.include(point);
  return box;
}

}  // namespace libstyle
