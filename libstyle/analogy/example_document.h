// SPDX-License-Identifier: Apache-2.0
// Examples from drawings: each curve of one document is a filtered example, and the curve at the
// same place of another, if there is one, is how it was before. Where there are more filtered
// curves than unfiltered ones, they are strokes: each belongs to the unfiltered curve that it lies
// along.
#pragma once

#include <vector>

#include "libstyle/analogy/example.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// `unfiltered` may be null. Subpaths count as curves; single points among them do not. Which places
// belong together is taken from the "t" values along the curves if both have them, from the
// vertices if both curves have the same number of them, 8 or more, and from the shapes otherwise.
// What goes along the filtered curves comes with them, as far as all of them have it.
// Throws Error when there is no curve, when there are fewer filtered than unfiltered ones, or when
// no stroke lies along one.
std::vector<ExamplePair> example_pairs(const Document* unfiltered, const Document& filtered);

// A path without geometry, painted and classed as the first path of a document, but not filled:
// what is drawn in its style. What belongs to the place of that path is left behind.
PathRecord painted_like(const Document& example);

}  // namespace libstyle
