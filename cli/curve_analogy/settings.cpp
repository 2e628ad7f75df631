// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/settings.h"

#include <cmath>

#include "converters/common/command.h"
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
  set(search.offset_weight, settings.offset_weight);
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

int Settings::document_count() const {
  if (variants && frames) throw UsageError("--frames does not go with --variants");
  const char* option = frames ? "--frames" : "--variants";
  const std::optional<double>& given = frames ? frames : variants;
  const int count = given ? whole_number(*given, option) : 1;
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
