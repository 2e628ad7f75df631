// SPDX-License-Identifier: Apache-2.0
// Curves made from an example alone, as documents.
#pragma once

#include <span>
#include <vector>

#include "libstyle/analogy/example.h"
#include "libstyle/analogy/synthesis.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// The filtered curves of pairs, every stroke on its own, with what goes along them.
std::vector<ExamplePair> synthesis_examples(std::span<const ExamplePair> pairs);

// A page with one curve of a style, painted as the first path of `example`, with a small margin
// round it. A placed curve keeps its place; the page then begins at the origin, and what goes
// beyond that is off the page.
Document synthesized_document(const CurveSynthesis& style, const SynthesizedCurve& made,
                              const Document& example);

}  // namespace libstyle
