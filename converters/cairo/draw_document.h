// SPDX-License-Identifier: Apache-2.0
// Draws a document on any Cairo surface.
//
// Records are drawn in order on what is there. A group is a layer only where it must be: with an
// opacity, or a clip that Cairo cannot take. Nesting is followed by a list, not by calls, so that
// its depth costs no stack.
#pragma once

#include <cairo.h>

#include <string>

#include "libstyle/base/warning.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// `context` has the identity as its matrix. What is drawn lies within its present clip. Warnings
// carry the line of their record; references to nothing are warned about and ignored. Throws Error,
// with `file` and the line of the record, when groups or clips nest too deep, a path would take
// Cairo minutes (crowding.h), or Cairo fails.
void draw_document(cairo_t* context, const Document& document, const Transform& device_from_page,
                   const std::string& file, const WarningHandler& warn);

}  // namespace libstyle
