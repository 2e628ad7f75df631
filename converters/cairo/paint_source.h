// SPDX-License-Identifier: Apache-2.0
// Colours and gradients as Cairo sources.
#pragma once

#include "converters/cairo/canvas.h"

namespace libstyle {

// Makes `paint`, at `opacity`, the source of what is drawn next. Returns false when it paints
// nothing: no paint, a gradient without stops, one that cannot be inverted, or a reference to no
// gradient, which is warned about on behalf of `user`.
bool set_source(Canvas& canvas, const Paint& paint, double opacity, const RecordBase& user);

}  // namespace libstyle
