// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/style_summary.h"

#include <algorithm>

#include "libstyle/geometry/arc_length.h"

namespace libstyle {

namespace {

Polyline stroke_on_page(const Sweep& sweep, std::span<const Lane::Sample> samples) {
  Polyline curve;
  for (const Lane::Sample& sample : samples) {
    curve.points.push_back(sweep.point_at(sample.length, sample.blur) +
                           to_page(sample.offset, sweep.frame_at(sample.length)));
  }
  return curve;
}

}  // namespace

std::vector<Polyline> filtered_curves(const Example& example) {
  std::vector<Polyline> curves;
  for (const ExampleLine& line : example.lines()) {
    for (const Lane& lane : line.lanes()) {
      for (std::size_t i = 0; i < lane.strokes().size(); ++i) {
        curves.push_back(stroke_on_page(line.sweep(), lane.samples_of(i)));
      }
    }
  }
  return curves;
}

StyleSummary summarize(const Example& example, const JumpModel& jumps,
                       const CurveAnalogyParameters& parameters, double mean_run,
                       std::size_t longest_run) {
  StyleSummary summary;
  summary.parameters = parameters;
  summary.lines = example.lines().size();
  double segments = 0;
  const std::vector<Polyline> filtered = filtered_curves(example);
  summary.strokes = filtered.size();
  for (const Polyline& curve : filtered) {
    summary.filtered_length += arc_length(curve);
    segments += static_cast<double>(segment_count(curve));
  }
  for (const ExampleLine& line : example.lines()) summary.unfiltered_length += line.length();
  summary.feature_size = example.feature_size();
  summary.feature_along = example.feature_along();
  summary.reach = example.reach();
  summary.sample_spacing = summary.filtered_length / segments;
  summary.states = example.state_count();
  summary.step = example.step();
  summary.tolerance = jumps.tolerance;
  const auto jumping = std::ranges::count_if(
      jumps.chain.rows, [](const ChainRow& row) { return !row.jumps.empty(); });
  summary.jumping_share = static_cast<double>(jumping) / static_cast<double>(summary.states);
  summary.mean_run = mean_run;
  summary.longest_run = longest_run;
  return summary;
}

}  // namespace libstyle
