// SPDX-License-Identifier: Apache-2.0
// The paths of a document in another form that draws the same lines.
#pragma once

#include "libstyle/curves/document.h"

namespace libstyle {

// Makes a record of each subpath, in order, with its share of the values along the curve. The first
// keeps the id, and with it the constraints and labels; the others get it with "~2", "~3" and so
// on. Every piece is painted as the path was: a hole becomes an area of its own.
void split_subpaths(Document& document);

// Makes polylines of all paths, clips too, that stay within `tolerance` px of the curves (flatten.h
// proves it). Values along a curve are interpolated in its parameter, colours too. `tolerance` > 0.
// Throws Error with the line of a path that would have more than kMaxFlattenedPoints points.
void flatten_paths(Document& document, double tolerance, const std::string& file);

}  // namespace libstyle
