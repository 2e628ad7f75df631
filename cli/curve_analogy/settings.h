// SPDX-License-Identifier: Apache-2.0
// The options of curve-analogy, as they are given and as the library takes them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "converters/common/command.h"
#include "libstyle/analogy/parameters.h"

namespace libstyle {

struct Settings {
  std::vector<std::string> inputs;
  std::string output = "-";
  std::string unfiltered;
  std::string filtered;
  std::vector<std::string> styles;
  std::vector<std::string> through;
  std::string style_file;
  std::string save_style;
  std::optional<double> variants, frames, frame_coherence;
  std::string scale = "1";
  std::optional<double> synthesize;
  std::string invariance;  // empty: as the work at hand wants it
  bool loose_ends = false;
  std::string method = "chain";
  bool faithful = false;
  // Symbols of the paper; unset: as the method has them.
  std::optional<double> levels, passes, neighborhood_samples, offset_weight, tangent_weight,
      coarse_weight, coherence, epsilon, step;
  bool explain = false;
  bool keep_going = false;
  int threads = 0;
  CurveAnalogyParameters parameters;
  std::vector<std::string> given;  // the long names of the options that were given

  bool is_given(std::string_view option) const;
  bool is_greedy() const { return method == "greedy" || faithful; }
  // How many documents are made of each, be they variants or frames; 1 if it is not said.
  int document_count() const;
  bool is_numbered() const { return variants || frames; }
  // How much of a frame stays in the next.
  double coherence_of_frames() const;
};

// The options that make a style what it is, and that a style file keeps.
std::vector<Option> style_options(Settings& settings);

// Throws UsageError for a symbol of the paper that was given and that nothing uses.
void refuse_idle_symbols(const Settings& settings, bool any_greedy);

// A factor; unset for "auto": as the drawing needs it. Throws UsageError.
std::optional<double> parse_scale(std::string_view text);

// The parameters with all that the options say, in range. Throws UsageError.
CurveAnalogyParameters checked_parameters(const Settings& settings, std::optional<double> scale);

// The name of one of several documents: what the outputs of `render -o '{name}.png'` are told
// apart by. Numbers begin at 1.
std::string variant_name(const std::string& name, int number);

}  // namespace libstyle
