// SPDX-License-Identifier: Apache-2.0
// The constraints of a drawing, brought from the ids of paths to their subpaths.
//
// A constraint speaks of a whole path: t is a fraction of the length of all its subpaths one after
// the other, and where one ends and the next begins it means the end. Without t, it is the nearest
// place of any of them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "libstyle/analogy/curve_constraint.h"
#include "libstyle/base/warning.h"
#include "libstyle/curves/document.h"
#include "libstyle/geometry/flatten.h"

namespace libstyle {

// A constraint that is not in the drawing.
struct AskedConstraint {
  ConstraintRecord constraint;
  std::string name;  // in messages
};

struct ConstrainablePath {
  const PathRecord* record = nullptr;
  std::span<const FlattenedSubpath> subpaths;  // empty: it stays as it is
  std::size_t group = 0;                       // the first path that is the same curve
};

// For each subpath.
using PathConstraints = std::vector<std::vector<CurveConstraint>>;

// For each of `paths`, which are in the order of the document. What holds for one path of a group
// holds for all. Constraints of the drawing that name nothing, or a path that stays as it is, have
// no effect, and neither have those of weight 0; of the asked ones that is warned of. Throws Error,
// naming both, when two hard constraints contradict each other.
std::vector<PathConstraints> place_constraints(const Document& document,
                                               std::span<const AskedConstraint> asked,
                                               std::span<const ConstrainablePath> paths,
                                               const WarningHandler& warn);

}  // namespace libstyle
