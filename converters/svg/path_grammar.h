// SPDX-License-Identifier: Apache-2.0
// The path grammar of SVG 1.1, section 8.3, in full: absolute and relative M L H V C S Q T A Z,
// repeated commands without their letter, numbers without separators ("1.5.5-3e2"), arc flags
// without separators ("a1 1 0 0110 0").
//
// The result has absolute M L C Z only. Quadratics are raised to cubics, which is exact; arcs
// become cubics within the error stated in arc.h. A command that follows Z without an M begins with
// an explicit M at the start of the closed subpath.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>

#include "libstyle/geometry/path.h"

namespace libstyle::svg {

struct ParsedPath {
  Path path;
  // Where the text stopped being a path, counted in characters from 0; unset: it is one. As SVG
  // asks (section F.2), everything before the segment with the error is kept.
  std::optional<std::size_t> error_at;
};

// Stops, as at an error, when the path has more than `point_limit` points.
ParsedPath parse_path_grammar(std::string_view text,
                              std::size_t point_limit = std::numeric_limits<std::size_t>::max());

// The same, but each arc is one cubic that begins and ends as the arc does and is wrong between:
// for those who ask only for the vertices that were written and the directions there.
Path parse_path_vertices(std::string_view text);

}  // namespace libstyle::svg
