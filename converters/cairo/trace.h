// SPDX-License-Identifier: Apache-2.0
// Hands paths to Cairo as its current path, within the range it can count in.
#pragma once

#include "converters/cairo/canvas.h"
#include "libstyle/geometry/path.h"

namespace libstyle {

// Adds `path`, moved by device_from_path, to the current path as it is.
void trace_path(cairo_t* context, const Path& path, const Transform& device_from_path);

// Adds the outline of an inside: cut to the window when it reaches far beyond it.
void trace_fill(Canvas& canvas, const Path& path);

inline cairo_fill_rule_t to_cairo(FillRule rule) {
  return rule == FillRule::kEvenOdd ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING;
}

}  // namespace libstyle
