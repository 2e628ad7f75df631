// SPDX-License-Identifier: Apache-2.0
// --report: what came out, for other programs. The man page describes the keys.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "converters/common/json_object.h"
#include "libstyle/analogy/drawing_measures.h"
#include "libstyle/analogy/style_summary.h"

namespace libstyle {

// The list of the report.
inline constexpr const char* kDrawings = "drawings";

struct DrawingReport {
  std::string file;      // where the drawing comes from; empty: from nothing
  std::size_t line = 0;  // of its header
  std::string name;
  std::uint64_t variant = 0;
  std::vector<JsonObject> styles;
};

JsonObject to_json(const DrawingReport& report);

JsonObject style_report(const std::string& name, const StyleSummary& summary,
                        const StyleMeasures& measures, std::uint64_t variant);

}  // namespace libstyle
