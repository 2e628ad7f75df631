// SPDX-License-Identifier: Apache-2.0
// Where a document puts colour.
#pragma once

#include <vector>

#include "libstyle/curves/document.h"

namespace libstyle {

// Whether a path has a stroke to draw, and how far the stroke reaches from the path, in page px.
bool has_stroke(const PathRecord& record);
double stroke_reach(const PathRecord& record);

// A box that holds everything a path draws; empty when it draws nothing.
Box ink_box(const PathRecord& record);

// The box of each record, on the page: what a path draws, what the members of a group draw
// (opacity and clips not counted). Empty for everything hidden and for other records.
std::vector<Box> ink_boxes(const Document& document);

// The box of everything drawn.
Box drawn_box(const Document& document);

}  // namespace libstyle
