// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/marker_vertices.h"

#include <utility>

#include "libstyle/geometry/bezier.h"

namespace libstyle::svg {
namespace {

// A line or curve of the path, or a point that stands alone.
struct Piece {
  CubicBezier curve;
  bool alone = false;
  bool closes = false;

  Point start() const { return curve.p0; }
  Point end() const { return curve.p3; }
};

// Finds the pieces of a path. A move stands alone when another follows it, or nothing.
class PieceFinder {
 public:
  std::vector<Piece> find(const Path& path) {
    const Point* next = path.points().data();
    for (const PathCommand command : path.commands()) {
      add(command, next);
      next += point_count(command);
    }
    leave_move();
    return std::move(pieces_);
  }

 private:
  void add(PathCommand command, const Point* points) {
    if (command == PathCommand::kMove) {
      leave_move();
      moved_ = !closed_;  // a move after Z may be there only to go on from it
      closed_ = false;
      start_ = current_ = points[0];
      return;
    }
    moved_ = false;
    closed_ = command == PathCommand::kClose;
    const Point end = closed_ ? start_ : points[point_count(command) - 1];
    const bool straight = command != PathCommand::kCubic;
    const CubicBezier curve = straight ? straight_bezier(current_, end)
                                       : CubicBezier{current_, points[0], points[1], end};
    pieces_.push_back({curve, false, closed_});
    current_ = end;
  }

  void leave_move() {
    if (moved_) pieces_.push_back({straight_bezier(current_, current_), true, false});
    moved_ = false;
  }

  std::vector<Piece> pieces_;
  Point start_, current_;
  bool moved_ = false;   // the last command was a move
  bool closed_ = false;  // the last command was Z
};

// Where a path comes from at the end of each piece, and goes to at the start of each; zero where
// nothing on that side, back to a point alone, has a direction.
struct Directions {
  std::vector<Vector> incoming;
  std::vector<Vector> outgoing;

  explicit Directions(const std::vector<Piece>& pieces)
      : incoming(pieces.size()), outgoing(pieces.size()) {
    Vector last, next;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Vector own = tangent_at(pieces[i].curve, 1);
      if (pieces[i].alone || own != Vector{}) last = own;
      incoming[i] = last;
    }
    for (std::size_t i = pieces.size(); i-- > 0;) {
      const Vector own = tangent_at(pieces[i].curve, 0);
      if (pieces[i].alone || own != Vector{}) next = own;
      outgoing[i] = next;
    }
  }
};

// Halfway between two directions; across, and never upwards, where they are opposite.
Vector between(Vector arriving, Vector leaving) {
  if (arriving == Vector{}) arriving = leaving;
  if (leaving == Vector{}) leaving = arriving;
  if (arriving == Vector{}) return {1, 0};
  const Vector sum = arriving + leaving;
  if (norm(sum) > 1e-9) return normalized(sum);
  const bool is_first = arriving.y > 0 || (arriving.y == 0 && arriving.x > 0);
  const Vector first = is_first ? arriving : leaving;
  return {-first.y, first.x};
}

}  // namespace

std::vector<MarkerVertex> marker_vertices(const Path& path) {
  const std::vector<Piece> pieces = PieceFinder().find(path);
  const Directions directions(pieces);
  std::vector<MarkerVertex> vertices;
  bool within = false;  // a subpath, rather than at the start or after a point alone
  const auto leave = [&](std::size_t last) {
    const bool is_ring = pieces[last].closes && pieces[last].end() == pieces[0].start();
    const Vector next = is_ring ? directions.outgoing[0] : Vector{};
    vertices.push_back(
        {MarkerPlace::kEnd, pieces[last].end(), between(directions.incoming[last], next)});
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].alone) {
      if (within) leave(i - 1);
      vertices.push_back({MarkerPlace::kMid, pieces[i].start(), {1, 0}});
    } else {
      const Vector before = within ? directions.incoming[i - 1] : Vector{};
      vertices.push_back({within ? MarkerPlace::kMid : MarkerPlace::kStart, pieces[i].start(),
                          between(before, directions.outgoing[i])});
    }
    within = !pieces[i].alone;
  }
  if (within) leave(pieces.size() - 1);
  return vertices;
}

}  // namespace libstyle::svg
