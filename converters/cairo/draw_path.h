// SPDX-License-Identifier: Apache-2.0
// Draws one path: fill and stroke in their order, at its opacity, within its clip.
#pragma once

#include "converters/cairo/canvas.h"

namespace libstyle {

// `ink` is what ink_box says of the record.
void draw_path(Canvas& canvas, const PathRecord& record, const Box& ink);

}  // namespace libstyle
