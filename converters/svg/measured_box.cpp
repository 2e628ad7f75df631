// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/measured_box.h"

#include "libstyle/geometry/path_segments.h"

namespace libstyle::svg {
namespace {

bool keeps_axes(const Transform& map) {
  return (map.b == 0 && map.c == 0) || (map.a == 0 && map.d == 0);
}

// The path without subpaths that are a move alone.
Path without_bare_moves(const Path& path) {
  Path result;
  const Point* next = path.points().data();
  const auto commands = path.commands();
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const std::size_t count = point_count(commands[i]);
    const bool is_last = i + 1 == commands.size() || commands[i + 1] == PathCommand::kMove;
    if (commands[i] != PathCommand::kMove || !is_last) result.append(commands[i], {next, count});
    next += count;
  }
  return result;
}

}  // namespace

Box mapped_box(const Box& box, const Transform& map) {
  Box result;
  if (box.empty()) return result;
  for (const double x : {box.low.x, box.high.x}) {
    for (const double y : {box.low.y, box.high.y}) result.include(map(Point{x, y}));
  }
  return result;
}

std::optional<Box> measured_box(const Path& path, const Transform& page_from_user) {
  Path drawn = without_bare_moves(path);
  if (keeps_axes(page_from_user)) return bounding_box(drawn);
  const std::optional<Transform> user_from_page = inverse(page_from_user);
  if (!user_from_page) return std::nullopt;
  drawn.transform(page_from_user);
  return mapped_box(bounding_box(drawn), *user_from_page);
}

}  // namespace libstyle::svg
