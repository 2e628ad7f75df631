// SPDX-License-Identifier: Apache-2.0
// A style as a document of curves, to be kept, shared and used again.
//
// The header has the key "style": 1, the version. Each pair of the example is a path of lines with
// the label "filtered", followed by one with the label "unfiltered" if there is one; where one
// unfiltered curve was drawn as several strokes, the further ones follow it with the label
// "stroke". Places of the two with equal values "t" along them belong together; without "t" which
// do, and where strokes lie, is found from the shapes. All other values along the filtered curves
// are features of the style (line_features.h), if all of these have them. The points are those that
// the style was learned from, so it draws the same bytes.
#pragma once

#include <span>
#include <vector>

#include "libstyle/analogy/example.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// Painted and named as `filtered`, the document that the filtered curves are from.
Document style_document(std::span<const ExamplePair> pairs, const Document& filtered);

bool is_style_document(const Document& document);

// The pairs of a style. Throws Error with the line (no file) of what is no style, or of a later
// version.
std::vector<ExamplePair> style_pairs(const Document& style);

}  // namespace libstyle
