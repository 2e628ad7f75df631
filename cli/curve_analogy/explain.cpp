// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/explain.h"

#include <cstdio>
#include <utility>

namespace libstyle {
namespace {

constexpr int kKeyWidth = 14;

// Four digits are as many as anybody compares.
std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string px(double value) { return rounded(value) + " px"; }
std::string percent(double share) { return rounded(100 * share) + " %"; }

class Table {
 public:
  explicit Table(std::string_view title) : text_(title) { text_ += ':'; }

  void row(std::string key, const std::string& value) {
    key.resize(kKeyWidth, ' ');
    text_ += "\n  " + key + value;
  }

  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string example_text(const StyleSummary& summary, const ExplainedUse& use) {
  std::string text = std::to_string(summary.lines) + (summary.lines == 1 ? " curve" : " curves");
  if (summary.strokes > summary.lines)
    text += " in " + std::to_string(summary.strokes) + " strokes";
  text += ", " + px(summary.filtered_length);
  if (!use.makes_new_lines) text += " along " + px(summary.unfiltered_length) + " unfiltered";
  return text;
}

std::string scale_text(double scale, const ExplainedUse& use) {
  if (use.has_fitting_scale) return rounded(scale) + ": chosen for this drawing";
  return rounded(scale) + (scale == 1 ? ": the size of the example" : ": as given");
}

std::string feature_text(const StyleSummary& summary, const ExplainedUse& use) {
  std::string text = px(summary.feature_size);
  if (!use.makes_new_lines) text += ", " + px(summary.feature_along) + " along the line";
  if (summary.parameters.feature_size) return text + ": as given";
  if (summary.strokes > summary.lines) {
    return text + ": found; no less than half the way from one stroke to the next";
  }
  // See feature_size.h and synthesis.cpp for the bounds.
  const double share = summary.feature_size / summary.filtered_length;
  if (use.makes_new_lines && share > 0.0099) {
    return text + ": found; no more than a hundredth of the example";
  }
  if (share > 0.083) {
    return text + ": the largest that is looked for; the example has no detail of one size";
  }
  return text + ": found; a blur by it takes 90 % of the extra length out of the example";
}

std::string runs_text(const StyleSummary& summary) {
  std::string text = rounded(summary.mean_run) + " feature sizes (" +
                     px(summary.mean_run * summary.feature_along) + ") on average";
  if (summary.longest_run == 0) return text;
  const auto longest = static_cast<double>(summary.longest_run);
  return text + ", at most " + px(longest * summary.step) + ", " +
         percent(longest / static_cast<double>(summary.states)) + " of the example";
}

std::string lines_text(const CurveAnalogyParameters& parameters) {
  std::string text =
      parameters.shape_weight > 0
          ? "corners not apart"
          : "corners where they turn by over " + rounded(parameters.corner_angle) + " degrees";
  text += parameters.smoothing > 0
              ? "; smoothed over " + rounded(parameters.smoothing) + " feature sizes"
              : "; not smoothed";
  text += "; the style not below " + rounded(parameters.smallest_scale) + " of its size";
  return text + (parameters.keep_ends ? "; ends held" : "; ends loose");
}

std::string search_text(const StyleSummary& summary, const ExplainedUse& use) {
  const StyleSummary::Search& search = *summary.search;
  const SearchParameters& p = search.parameters;
  const double offset_weight = use.makes_new_lines ? p.synthesis_offset_weight : p.offset_weight;
  return "finest spacing " + px(search.finest_spacing) + "; " + std::to_string(search.levels) +
         " levels, " + rounded(p.level_ratio) + " times as coarse each; " +
         std::to_string(p.coarsest_passes) + " passes of the coarsest, " +
         std::to_string(p.passes) + " of the others; n " + std::to_string(p.neighborhood_samples) +
         ", " + rounded(p.sample_spacing) + " spacings apart; w_OFFSET " + rounded(offset_weight) +
         "; w_delta " + rounded(p.tangent_weight) + "; w_B " + rounded(p.shape_weight) +
         "; w_B'(l-1) " + rounded(p.coarse_weight) + "; kappa " + rounded(p.coherence) +
         "; epsilon " + rounded(p.epsilon) + ", " + rounded(p.fine_epsilon) +
         " below the coarsest " + std::to_string(p.random_levels) + "; Delta t " + rounded(p.step);
}

}  // namespace

std::string explanation(std::string_view name, const StyleSummary& summary,
                        const ExplainedUse& use) {
  const CurveAnalogyParameters& parameters = summary.parameters;
  Table table(name);
  table.row("example", example_text(summary, use));
  table.row("scale", scale_text(parameters.scale, use));
  table.row("feature size", feature_text(summary, use));
  if (!use.makes_new_lines) {
    table.row("reach", px(summary.reach) + ": 95 % of the style is nearer to its mean offset");
  }
  table.row("samples", "about " + std::to_string(parameters.samples) + ", " +
                           px(summary.sample_spacing) + " apart");
  table.row("direction", parameters.invariance == Invariance::kRotate ? "turns with the lines"
                                                                      : "kept on the page");
  table.row("seed", std::to_string(parameters.seed));
  if (!use.makes_new_lines) table.row("lines", lines_text(parameters));
  if (summary.search) {
    table.row("method", "greedy");
    table.row("search", search_text(summary, use));
    return table.take();
  }
  table.row("method", use.makes_new_lines || parameters.shape_weight == 0
                          ? "chain, pieces at random"
                          : "chain, pieces by shape, weight " + rounded(parameters.shape_weight));
  table.row("states", std::to_string(summary.states) + " of " + px(summary.step));
  table.row("tolerance",
            rounded(summary.tolerance) + " px^2: tau, the cost at which a jump still looks alike");
  table.row("jumps", "from " + percent(summary.jumping_share) + " of the states");
  table.row("runs", runs_text(summary));
  return table.take();
}

}  // namespace libstyle
