// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/measures_report.h"

namespace libstyle {
namespace {

JsonObject example_report(const StyleSummary& summary) {
  return JsonObject()
      .count("curves", summary.lines)
      .count("strokes", summary.strokes)
      .number("filtered-length", summary.filtered_length)
      .number("unfiltered-length", summary.unfiltered_length)
      .number("feature-size", summary.feature_size)
      .number("feature-size-along", summary.feature_along)
      .number("reach", summary.reach)
      .count("states", summary.states)
      .number("step", summary.step)
      .number("tolerance", summary.tolerance)
      .number("jumping-share", summary.jumping_share);
}

JsonObject runs_report(const StyleMeasures& measures, double scale) {
  return JsonObject()
      .count("count", measures.runs)
      .number("median", measures.median_run / scale)
      .number("longest", measures.longest_run / scale)
      .number("median-share", measures.median_run_share)
      .number("longest-share", measures.longest_run_share)
      .number("coverage", measures.coverage);
}

}  // namespace

JsonObject style_report(const std::string& name, const StyleSummary& summary,
                        const StyleMeasures& measures, std::uint64_t variant) {
  const CurveAnalogyParameters& parameters = summary.parameters;
  return JsonObject()
      .text("style", name)
      .count("seed", parameters.seed + variant)
      .number("scale", parameters.scale)
      .object("example", example_report(summary))
      .count("curves", measures.curves)
      .count("kept", measures.kept)
      .number("length", measures.length)
      .count("vertices-before", measures.vertices_before)
      .count("vertices-after", measures.vertices_after)
      .number("end-distance", measures.end_distance)
      .count("held", measures.held)
      .number("held-distance", measures.held_distance)
      .number("fit-distance", measures.fit_distance)
      .object("runs", runs_report(measures, parameters.scale))
      .number("turning-distance", measures.turning_distance)
      .number("turning-distance-of-halves", measures.turning_distance_of_halves)
      .number("mean-scale", measures.mean_scale)
      .number("small-share", measures.small_share);
}

JsonObject to_json(const DrawingReport& report) {
  return JsonObject()
      .text_or_null("file", report.file)
      .line("line", report.line)
      .text_or_null("name", report.name)
      .count("variant", report.variant + 1)
      .list("styles", report.styles);
}

}  // namespace libstyle
