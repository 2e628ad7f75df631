// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/trace.h"

#include "converters/cairo/crowding.h"
#include "converters/cairo/safe_path.h"

namespace libstyle {

void trace_path(cairo_t* context, const Path& path, const Transform& device_from_path) {
  const Point* next = path.points().data();
  Point p[3];
  for (const PathCommand command : path.commands()) {
    const std::size_t count = point_count(command);
    for (std::size_t i = 0; i < count; ++i) p[i] = device_from_path(next[i]);
    next += count;
    switch (command) {
      case PathCommand::kMove:
        cairo_move_to(context, p[0].x, p[0].y);
        break;
      case PathCommand::kLine:
        cairo_line_to(context, p[0].x, p[0].y);
        break;
      case PathCommand::kCubic:
        cairo_curve_to(context, p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y);
        break;
      case PathCommand::kClose:
        cairo_close_path(context);
        break;
    }
  }
}

void trace_fill(Canvas& canvas, const Path& path) {
  count_edges(canvas, path, canvas.device_from_page, 1);
  const Box box = transformed(path.control_box(), canvas.device_from_page);
  if (box.empty() || is_near(box, canvas.window)) {
    trace_path(canvas.context, path, canvas.device_from_page);
    return;
  }
  Path on_device = path;
  on_device.transform(canvas.device_from_page);
  trace_path(canvas.context, cut_fill(on_device, canvas.window), Transform{});
}

}  // namespace libstyle
