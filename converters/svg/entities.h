// SPDX-License-Identifier: Apache-2.0
// The entities that a file declares for itself: <!DOCTYPE svg [ <!ENTITY name "value"> ]>.
// The XML parser knows none of them, so they are put in their places in the text before it runs.
#pragma once

#include <cstddef>
#include <string>

#include "libstyle/base/warning.h"

namespace libstyle::svg {

struct EntityLimits {
  std::size_t bytes = std::size_t{16} << 20;  // what all references of a file expand to
  int depth = 32;                             // entities within entities
};

// Returns `text` with every reference to an internal entity expanded and the document type
// declaration blanked. Line numbers stay: an expansion has no line breaks. External entities are
// never opened; each one referred to is warned about and leaves nothing.
// Throws Error when an entity refers to itself or the expansion passes a limit.
std::string expand_entities(std::string text, const std::string& file, const EntityLimits& limits,
                            const WarningHandler& warn);

}  // namespace libstyle::svg
