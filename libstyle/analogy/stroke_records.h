// SPDX-License-Identifier: Apache-2.0
// Areas that are drawn as strokes: strokes have no inside, so an area keeps its shape, and its line
// becomes a record of its own.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// A path of a drawing, and what it is drawn in.
struct StyledPath {
  PathRecord* record;
  std::size_t style;                              // StylePlan::kNone: it stays as it is
  const CurveAnalogy* analogy;                    // null: it stays as it is
  std::optional<PathRecord> line = std::nullopt;  // of an area that is drawn as strokes

  PathRecord& drawn() { return line ? *line : *record; }
};

// Parts a record that is to be drawn as strokes. An area without a line stays as it is.
void part_area_from_line(StyledPath& path);

// Puts the lines of areas in front of them, or behind, as they were painted, with ids of their own:
// those of the areas with numbers behind. `paths` are all paths of the document, in order.
void insert_lines(Document& document, std::span<StyledPath> paths);

}  // namespace libstyle
