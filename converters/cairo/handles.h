// SPDX-License-Identifier: Apache-2.0
// Owners of Cairo's objects, and its errors as ours.
#pragma once

#include <cairo.h>

#include <memory>
#include <string>

#include "libstyle/base/error.h"

namespace libstyle {

struct CairoDeleter {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_pattern_t* pattern) const { cairo_pattern_destroy(pattern); }
};

using CairoContext = std::unique_ptr<cairo_t, CairoDeleter>;
using CairoSurface = std::unique_ptr<cairo_surface_t, CairoDeleter>;
using CairoPattern = std::unique_ptr<cairo_pattern_t, CairoDeleter>;

// Cairo keeps the first error and ignores all calls after it, so asking once at the end is enough.
inline void check_cairo(cairo_status_t status, const char* doing) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw Error(std::string(doing) + ": " + cairo_status_to_string(status));
}

}  // namespace libstyle
