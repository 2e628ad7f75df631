// SPDX-License-Identifier: Apache-2.0
// Curves made from an example alone, as documents.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "libstyle/analogy/synthesis.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// The subpaths of a document as examples, with what goes along them. Throws Error when there are
// none.
std::vector<ExamplePair> synthesis_examples(const Document& example);

// A page with one curve, painted as the first path of `example`, with a small margin round it.
Document synthesized_document(const CurveSynthesis& style, const Document& example, double length,
                              std::uint64_t variant);

}  // namespace libstyle
