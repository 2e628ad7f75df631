// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/stroke.h"

#include <algorithm>
#include <cmath>

#include "converters/cairo/crowding.h"
#include "converters/cairo/dash_pattern.h"
#include "converters/cairo/ink.h"
#include "converters/cairo/paint_source.h"
#include "converters/cairo/safe_path.h"
#include "converters/cairo/trace.h"

namespace libstyle {
namespace {

cairo_line_cap_t to_cairo(LineCap cap) {
  switch (cap) {
    case LineCap::kRound:
      return CAIRO_LINE_CAP_ROUND;
    case LineCap::kSquare:
      return CAIRO_LINE_CAP_SQUARE;
    default:
      return CAIRO_LINE_CAP_BUTT;
  }
}

cairo_line_join_t to_cairo(LineJoin join) {
  switch (join) {
    case LineJoin::kRound:
      return CAIRO_LINE_JOIN_ROUND;
    case LineJoin::kBevel:
      return CAIRO_LINE_JOIN_BEVEL;
    default:
      return CAIRO_LINE_JOIN_MITER;
  }
}

// The pen of a path: how its space, where width and dashes are measured, lies on the device.
struct Pen {
  Transform device_from_pen;
  Transform pen_from_device;
  double reach;  // device px
};

std::optional<Pen> make_pen(const Canvas& canvas, const PathRecord& record) {
  const Style& style = record.style;
  Transform device_from_pen =
      canvas.device_from_page * style.stroke_transform.value_or(Transform{});
  device_from_pen.e = device_from_pen.f = 0;
  const auto pen_from_device = inverse(device_from_pen);
  if (!pen_from_device || !device_from_pen.is_finite()) return std::nullopt;
  const double scale = std::sqrt(std::abs(canvas.device_from_page.determinant()));
  return Pen{device_from_pen, *pen_from_device, stroke_reach(record) * scale};
}

// Adds the dots of square caps: Cairo draws a subpath without length for round caps only, since it
// has no direction. SVG gives it that of the pen's x axis; so does a line too short to be seen.
void trace_square_dots(cairo_t* context, const Path& path, const Transform& device_from_path,
                       const Pen& pen) {
  constexpr double kShort = 1.0 / 64;  // px; a few steps of Cairo's fixed point
  const Vector half = kShort / 2 * normalized(pen.device_from_pen.linear({1, 0}));
  const Point* next = path.points().data();
  const auto commands = path.commands();
  Point start;
  bool has_length = false;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const std::size_t count = point_count(commands[i]);
    if (commands[i] == PathCommand::kMove) {
      start = *next;
      has_length = false;
    }
    has_length = has_length || std::any_of(next, next + count, [&](Point p) { return p != start; });
    next += count;
    const bool is_last = i + 1 == commands.size() || commands[i + 1] == PathCommand::kMove;
    if (!is_last || has_length || commands[i] == PathCommand::kMove) continue;
    const Point center = device_from_path(start);
    cairo_move_to(context, center.x - half.x, center.y - half.y);
    cairo_line_to(context, center.x + half.x, center.y + half.y);
  }
}

// The length by control points, an upper bound.
double pen_length(const Path& path, const Transform& pen_from_path) {
  double length = 0;
  const auto points = path.points();
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += norm(pen_from_path.linear(points[i] - points[i - 1]));
  }
  return length;
}

// Sets the dashes of a run. Returns the share of it that is to be painted evenly instead: below 1
// when the dashes are too many to be told apart.
double set_dashes(cairo_t* context, const DashPattern& pattern, double length) {
  cairo_set_dash(context, nullptr, 0, 0);
  if (pattern.lengths.empty()) return 1;
  if (pattern.pieces(length) > kMostDashes) {
    double drawn = 0;
    for (std::size_t i = 0; i < pattern.lengths.size(); i += 2) drawn += pattern.lengths[i];
    return drawn / pattern.period;
  }
  cairo_set_dash(context, pattern.lengths.data(), static_cast<int>(pattern.lengths.size()),
                 pattern.offset);
  return 1;
}

void set_style(cairo_t* context, const Style& style, const Pen& pen) {
  const double widest = kMostReach / std::sqrt(std::abs(pen.device_from_pen.determinant()));
  cairo_set_line_width(context, std::min(style.stroke_width, widest));
  cairo_set_line_cap(context, to_cairo(style.line_cap));
  cairo_set_line_join(context, to_cairo(style.line_join));
  cairo_set_miter_limit(context, style.miter_limit);
}

// The source follows Cairo's matrix when it is set, so the pen's matrix is there for the stroke
// alone.
void stroke_current_path(cairo_t* context, const Pen& pen) {
  const cairo_matrix_t matrix = to_cairo(pen.device_from_pen);
  cairo_set_matrix(context, &matrix);
  cairo_stroke(context);
  cairo_identity_matrix(context);
}

std::vector<StrokeRun> cut_to_window(const Canvas& canvas, const Path& path, const Pen& pen) {
  const double reach = std::min(pen.reach, kMostReach) + 1;
  const Box window = {canvas.window.low - Point{reach, reach},
                      canvas.window.high + Point{reach, reach}};
  Path on_device = path;
  on_device.transform(canvas.device_from_page);
  return cut_stroke(on_device, window, pen.pen_from_device);
}

}  // namespace

void stroke_path(Canvas& canvas, const PathRecord& record, const Paint& paint, double opacity) {
  const auto pen = make_pen(canvas, record);
  if (!pen || record.style.stroke_width <= 0) return;
  cairo_t* context = canvas.context;
  count_edges(canvas, record.path, canvas.device_from_page, 2);
  set_style(context, record.style, *pen);
  const auto stroke_run = [&](const Path& path, const Transform& device_from_path, double start) {
    const double length = pen_length(path, pen->pen_from_device * device_from_path);
    const double tint = set_dashes(context, make_dash_pattern(record.style, start), length);
    if (!set_source(canvas, paint, opacity * tint, record)) return;
    cairo_new_path(context);
    trace_path(context, path, device_from_path);
    if (record.style.line_cap == LineCap::kSquare) {
      trace_square_dots(context, path, device_from_path, *pen);
    }
    stroke_current_path(context, *pen);
  };
  const Box box = transformed(record.path.control_box(), canvas.device_from_page);
  if (is_near(box, canvas.window)) {
    stroke_run(record.path, canvas.device_from_page, 0);
    return;
  }
  for (const StrokeRun& run : cut_to_window(canvas, record.path, *pen)) {
    stroke_run(run.path, Transform{}, run.start_length);
  }
}

}  // namespace libstyle
