// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/settings.h"

#include <algorithm>
#include <cmath>

#include "libstyle/base/error.h"
#include "libstyle/base/number.h"

namespace libstyle {
namespace {

constexpr double kUsualCoherence = 0.7;

int whole_number(double value, const char* option) {
  if (!(std::abs(value) < 1e6) || value != std::floor(value)) {
    throw UsageError(std::string(option) + " is a whole number");
  }
  return static_cast<int>(value);
}

// The paper's symbols as they are printed or repaired, and as the user wants them.
SearchParameters search_parameters(const Settings& settings) {
  SearchParameters search;
  if (settings.faithful) {
    search = paper_parameters();
    search.finest_spacing.reset();  // as fine as --samples says
  }
  const auto set = [](double& member, const std::optional<double>& value) {
    if (value) member = *value;
  };
  set(settings.synthesize ? search.synthesis_offset_weight : search.offset_weight,
      settings.offset_weight);
  set(search.tangent_weight, settings.tangent_weight);
  set(search.coarse_weight, settings.coarse_weight);
  set(search.coherence, settings.coherence);
  set(search.epsilon, settings.epsilon);
  set(search.step, settings.step);
  if (settings.levels) search.levels = whole_number(*settings.levels, "--levels");
  if (settings.passes) search.passes = whole_number(*settings.passes, "--passes");
  if (settings.neighborhood_samples) {
    search.neighborhood_samples = whole_number(*settings.neighborhood_samples, "--neighborhood");
  }
  return search;
}

}  // namespace

std::vector<Option> style_options(Settings& settings) {
  CurveAnalogyParameters& p = settings.parameters;
  return {
      {"--seed", "N", "another number draws other lines in the same style", &p.seed},
      {"--scale", "FACTOR", "the size of the style: a factor, or auto to suit the drawing",
       &settings.scale},
      {"--invariance",
       "KIND",
       "whether the style turns with the lines: rotate or translate",
       &settings.invariance,
       HistoryUse::kRecorded,
       {"rotate", "translate"}},
      {"--shape-weight", "W", "how much the shape of a line decides what is drawn there",
       &p.shape_weight},
      {"--feature-size", "PX", "half the size of a feature of the example", &p.feature_size},
      {"--samples", "N", "how finely the example is cut", &p.samples},
      {"--mean-run", "N", "feature sizes copied from the example in one go", &p.mean_run},
      {"--smoothing", "N", "feature sizes over which lines lose their own detail", &p.smoothing},
      {"--smallest-scale", "FACTOR", "how small the style may get where there is no room",
       &p.smallest_scale},
      {"--corner-angle", "DEGREES", "lines that turn more sharply have a corner there",
       &p.corner_angle},
      {"--loose-ends", "", "do not hold the ends of lines in their places", &settings.loose_ends},
      {"--method",
       "KIND",
       "chain, or greedy: the paper's search, repaired",
       &settings.method,
       HistoryUse::kRecorded,
       {"chain", "greedy"}},
      {"--faithful", "", "greedy as the paper prints it, but for its misprints",
       &settings.faithful},
      {"--levels", "N", "of the pyramid (greedy)", &settings.levels},
      {"--passes", "N", "refinements of each level (greedy)", &settings.passes},
      {"--neighborhood", "N", "samples of a neighborhood, odd (greedy)",
       &settings.neighborhood_samples},
      {"--w-offset", "W", "weight of the offset from the line (greedy)", &settings.offset_weight},
      {"--w-delta", "W", "weight of tangents (greedy)", &settings.tangent_weight},
      {"--w-coarse", "W", "weight of the level above (greedy)", &settings.coarse_weight},
      {"--kappa", "K", "what it costs to leave a copied piece (greedy)", &settings.coherence},
      {"--epsilon", "E", "how much worse than the best may be chosen (greedy)", &settings.epsilon},
      {"--delta-t", "N", "spacings in a step of the first pass (greedy)", &settings.step}};
}

bool Settings::is_given(std::string_view option) const {
  return std::ranges::find(given, option) != given.end();
}

void refuse_idle_symbols(const Settings& settings, bool any_greedy) {
  if (settings.is_given("--faithful") && settings.is_given("--method") &&
      settings.method == "chain") {
    throw UsageError("--faithful is greedy; leave out --method chain");
  }
  if (any_greedy) return;
  for (const char* symbol : {"--levels", "--passes", "--neighborhood", "--w-offset", "--w-delta",
                             "--w-coarse", "--kappa", "--epsilon", "--delta-t"}) {
    if (settings.is_given(symbol)) {
      throw UsageError(std::string(symbol) + " is for --method greedy; give that too");
    }
  }
}

int Settings::document_count() const {
  if (variants && frames) throw UsageError("--frames does not go with --variants");
  const char* option = frames ? "--frames" : "--variants";
  const std::optional<double>& given_count = frames ? frames : variants;
  const int count = given_count ? whole_number(*given_count, option) : 1;
  if (count < 1) throw UsageError(std::string(option) + " is 1 or more");
  return count;
}

double Settings::coherence_of_frames() const {
  if (frame_coherence && !frames) throw UsageError("--coherence is for --frames");
  const double value = frame_coherence.value_or(kUsualCoherence);
  if (!(value >= 0 && value <= 1)) throw UsageError("--coherence is 0 to 1");
  if (frames && (is_greedy() || parameters.shape_weight > 0)) {
    throw UsageError(
        "--frames is for lines that are drawn at random by the chain, not for --shape-weight or "
        "--method greedy");
  }
  return value;
}

std::optional<double> parse_scale(std::string_view text) {
  if (text == "auto") return std::nullopt;
  double scale = 0;
  if (!take_number(text, scale) || !text.empty()) {
    throw UsageError("--scale is a number or auto");
  }
  return scale;
}

CurveAnalogyParameters checked_parameters(const Settings& settings, std::optional<double> scale) {
  CurveAnalogyParameters parameters = settings.parameters;
  parameters.scale = scale.value_or(1);
  parameters.keep_ends = !settings.loose_ends;
  const std::string usual = settings.synthesize ? "translate" : "rotate";
  const std::string& invariance = settings.invariance.empty() ? usual : settings.invariance;
  if (invariance == "translate") parameters.invariance = Invariance::kTranslate;
  if (settings.is_greedy()) parameters.method = AnalogyMethod::kGreedy;
  parameters.search = search_parameters(settings);
  try {
    validate(parameters);
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
  return parameters;
}

std::string variant_name(const std::string& name, int number) {
  return (name.empty() ? "unnamed" : name) + '-' + std::to_string(number);
}

}  // namespace libstyle
