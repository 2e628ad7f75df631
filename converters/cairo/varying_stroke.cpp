// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/varying_stroke.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "converters/cairo/crowding.h"
#include "converters/cairo/handles.h"
#include "converters/cairo/paint_source.h"
#include "converters/cairo/ribbon.h"
#include "converters/cairo/safe_path.h"

namespace libstyle {
namespace {

// A line of the ribbon; offsets lead from the curve to its right edge.
struct Piece {
  RibbonPoint from, to;
  Vector from_offset, to_offset;
};

struct Outline {
  std::vector<Piece> pieces;
  std::vector<RibbonPoint> discs;
  std::vector<RibbonPoint> ends;  // where colour must reach a little further than the outline
};

Vector perpendicular(Vector v) { return {-v.y, v.x}; }

// The offset at a joint for both of its lines, or nothing where they turn too far to share one
// (20 degrees: below that the corner of the shared edge stays within 1.5 % of the radius).
std::optional<Vector> shared_offset(Vector before, Vector after, double radius) {
  constexpr double kSmooth = 0.94;  // cos(20 degrees)
  if (dot(before, after) < kSmooth) return std::nullopt;
  const Vector along = normalized(before + after);
  return radius / dot(along, after) * perpendicular(along);
}

class OutlineMaker {
 public:
  OutlineMaker(const Ribbon& ribbon, LineCap cap, Outline& outline)
      : ribbon_(ribbon), cap_(cap), outline_(outline) {}

  void make() {
    if (ribbon_.points.size() == 1) {
      make_dot(ribbon_.points[0]);
      return;
    }
    const std::size_t lines = ribbon_.points.size() - (ribbon_.closed ? 0 : 1);
    for (std::size_t i = 0; i < lines; ++i) add_line(i);
    if (!ribbon_.closed) {
      add_cap(ribbon_.points.front(), -end_direction(0, 0));
      add_cap(ribbon_.points.back(), end_direction(lines - 1, lines));
    }
  }

 private:
  const RibbonPoint& point(std::size_t i) const {
    return ribbon_.points[i % ribbon_.points.size()];
  }
  Vector direction(std::size_t line) const {
    return normalized(point(line + 1).place - point(line).place);
  }

  // The direction of the curve at the end of an open ribbon, which its outermost line may not quite
  // have.
  Vector end_direction(std::size_t line, std::size_t i) const {
    const Vector tangent = i == 0 ? ribbon_.start_tangent : ribbon_.end_tangent;
    return tangent == Vector{} ? direction(line) : tangent;
  }

  // The offset of line `line` at point `i`, one of its two.
  Vector offset(std::size_t line, std::size_t i) {
    const std::size_t count = ribbon_.points.size();
    if (!ribbon_.closed && (i == 0 || i + 1 == count)) {
      return point(i).radius * perpendicular(end_direction(line, i));
    }
    const Vector own = point(i).radius * perpendicular(direction(line));
    const std::size_t before = (i + count - 1) % count;
    const auto shared = shared_offset(direction(before), direction(i % count), point(i).radius);
    if (shared) return *shared;
    outline_.discs.push_back(point(i));
    return own;
  }

  void add_line(std::size_t i) {
    outline_.pieces.push_back({point(i), point(i + 1), offset(i, i), offset(i, i + 1)});
  }

  void add_cap(const RibbonPoint& end, Vector outwards) {
    outline_.ends.push_back(end);
    if (cap_ == LineCap::kRound) outline_.discs.push_back(end);
    if (cap_ != LineCap::kSquare || !(end.radius > 0)) return;
    RibbonPoint tip = end;
    tip.place += end.radius * outwards;
    const Vector across = end.radius * perpendicular(outwards);
    outline_.pieces.push_back({end, tip, across, across});
    outline_.ends.push_back(tip);
  }

  void make_dot(const RibbonPoint& dot) {
    if (cap_ == LineCap::kButt) return;
    add_cap(dot, {1, 0});
    add_cap(dot, {-1, 0});
  }

  const Ribbon& ribbon_;
  LineCap cap_;
  Outline& outline_;
};

// Keeps what can be seen, cut to where Cairo can count.
void cut_to_window(Outline& outline, const Box& window) {
  const auto within = [&](double reach) {
    return Box{window.low - Point{reach, reach}, window.high + Point{reach, reach}};
  };
  std::vector<Piece> kept;
  for (const Piece& piece : outline.pieces) {
    const double reach = std::max(norm(piece.from_offset), norm(piece.to_offset)) + 2;
    const auto range = visible_range(piece.from.place, piece.to.place, within(reach));
    if (!range) continue;
    const auto [first, last] = *range;
    kept.push_back({lerp(piece.from, piece.to, first), lerp(piece.from, piece.to, last),
                    lerp(piece.from_offset, piece.to_offset, first),
                    lerp(piece.from_offset, piece.to_offset, last)});
  }
  outline.pieces = std::move(kept);
  std::erase_if(outline.discs, [&](const RibbonPoint& disc) {
    return !visible_range(disc.place, disc.place, within(disc.radius + 2));
  });
}

void trace_polygon(cairo_t* context, std::initializer_list<Point> corners) {
  cairo_new_sub_path(context);
  for (const Point corner : corners) cairo_line_to(context, corner.x, corner.y);
  cairo_close_path(context);
}

// In the direction in which Cairo draws its discs.
void trace_triangle(cairo_t* context, Point a, Point b, Point c) {
  if (cross(b - a, c - a) < 0) std::swap(b, c);
  trace_polygon(context, {a, b, c});
}

// Where the two ends of a piece cross, in a turn tighter than the radius.
std::optional<Point> crossing_of_ends(const Piece& piece) {
  const Vector along = piece.to.place - piece.from.place;
  const double area = cross(piece.from_offset, piece.to_offset);
  if (area == 0) return std::nullopt;
  const double on_from = cross(along, piece.to_offset) / area;
  const double on_to = cross(along, piece.from_offset) / area;
  if (std::abs(on_from) >= 1 || std::abs(on_to) >= 1) return std::nullopt;
  return piece.from.place + on_from * piece.from_offset;
}

void trace_piece(cairo_t* context, const Piece& piece) {
  const Point from_left = piece.from.place - piece.from_offset;
  const Point from_right = piece.from.place + piece.from_offset;
  const Point to_left = piece.to.place - piece.to_offset;
  const Point to_right = piece.to.place + piece.to_offset;
  if (const auto crossing = crossing_of_ends(piece)) {
    trace_triangle(context, *crossing, from_left, to_left);
    trace_triangle(context, *crossing, from_right, to_right);
  } else {
    trace_polygon(context, {from_left, to_left, to_right, from_right});
  }
}

void trace_outline(cairo_t* context, const Outline& outline) {
  cairo_new_path(context);
  for (const Piece& piece : outline.pieces) trace_piece(context, piece);
  for (const RibbonPoint& disc : outline.discs) {
    cairo_new_sub_path(context);
    cairo_arc(context, disc.place.x, disc.place.y, disc.radius, 0, 2 * std::numbers::pi);
    cairo_close_path(context);
  }
  cairo_set_fill_rule(context, CAIRO_FILL_RULE_WINDING);
}

using Rgba = std::array<double, 4>;

void add_patch(cairo_pattern_t* mesh, const Point (&corners)[4], const Rgba& from, const Rgba& to,
               double opacity) {
  cairo_mesh_pattern_begin_patch(mesh);
  cairo_mesh_pattern_move_to(mesh, corners[0].x, corners[0].y);
  for (int i = 1; i < 4; ++i) cairo_mesh_pattern_line_to(mesh, corners[i].x, corners[i].y);
  for (unsigned i = 0; i < 4; ++i) {
    const Rgba& c = i == 0 || i == 3 ? from : to;
    cairo_mesh_pattern_set_corner_color_rgba(mesh, i, c[0], c[1], c[2], c[3] * opacity);
  }
  cairo_mesh_pattern_end_patch(mesh);
}

// The colours reach kBleed past the outline, so that pixels on its edge find one. Later patches
// cover earlier ones: first what fills corners and ends, then the lines.
CairoPattern make_mesh(const Outline& outline, double opacity) {
  constexpr double kBleed = 1;  // px
  CairoPattern mesh(cairo_pattern_create_mesh());
  const auto add_square = [&](const RibbonPoint& p) {
    const double half = p.radius + kBleed;
    add_patch(mesh.get(),
              {p.place + Point{-half, -half}, p.place + Point{half, -half},
               p.place + Point{half, half}, p.place + Point{-half, half}},
              p.color, p.color, opacity);
  };
  for (const RibbonPoint& end : outline.ends) add_square(end);
  for (const RibbonPoint& disc : outline.discs) add_square(disc);
  for (const Piece& piece : outline.pieces) {
    const Vector from = piece.from_offset + kBleed * normalized(piece.from_offset);
    const Vector to = piece.to_offset + kBleed * normalized(piece.to_offset);
    add_patch(mesh.get(),
              {piece.from.place - from, piece.to.place - to, piece.to.place + to,
               piece.from.place + from},
              piece.from.color, piece.to.color, opacity);
  }
  return mesh;
}

}  // namespace

bool varies_along(const PathRecord& record) {
  return record.along.find("width") || !record.along.colors.empty();
}

void draw_varying_stroke(Canvas& canvas, const PathRecord& record, const Paint& paint,
                         double opacity) {
  count_edges(canvas, record.path, canvas.device_from_page, 2);
  const double scale = std::sqrt(std::abs(canvas.device_from_page.determinant()));
  const auto ribbons = cut_dashes(make_ribbons(record, canvas.device_from_page),
                                  make_dash_pattern(record.style, 0, scale));
  Outline outline;
  for (const Ribbon& ribbon : ribbons) {
    OutlineMaker(ribbon, record.style.line_cap, outline).make();
  }
  cut_to_window(outline, canvas.window);
  if (record.along.colors.empty()) {
    if (!set_source(canvas, paint, opacity, record)) return;
  } else {
    cairo_set_source(canvas.context, make_mesh(outline, opacity).get());
  }
  trace_outline(canvas.context, outline);
  cairo_fill(canvas.context);
}

}  // namespace libstyle
