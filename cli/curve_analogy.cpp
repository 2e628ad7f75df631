// SPDX-License-Identifier: Apache-2.0
// curve-analogy: the curves of a drawing in the style of an example.
#include "libstyle/analogy/curve_analogy.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/style_option.h"
#include "converters/common/command.h"
#include "converters/common/files.h"
#include "converters/svg/document_input.h"
#include "libstyle/analogy/drawing.h"
#include "libstyle/analogy/example_document.h"
#include "libstyle/analogy/style_set.h"
#include "libstyle/analogy/synthesis_document.h"
#include "libstyle/base/error.h"
#include "libstyle/base/number.h"
#include "libstyle/curves/writer.h"

namespace libstyle {
namespace {

struct Settings {
  std::vector<std::string> inputs;
  std::string output = "-";
  std::string unfiltered;
  std::string filtered;
  std::vector<std::string> styles;
  std::optional<double> variants;
  std::string scale = "1";
  std::optional<double> synthesize;
  std::string invariance;  // empty: as the work at hand wants it
  bool loose_ends = false;
  std::string method = "chain";
  bool faithful = false;
  // Symbols of the paper; unset: as the method has them.
  std::optional<double> levels, passes, neighborhood_samples, offset_weight, tangent_weight,
      coarse_weight, coherence, epsilon, step;
  int threads = 0;
  CurveAnalogyParameters parameters;
};

Document read_example(const std::string& name, Session& session) {
  DocumentInput input(name, session.warning_handler());
  Document document;
  if (!input.read(document)) throw Error({display_name(name)}, "the example is empty");
  return document;
}

std::vector<ExamplePair> read_pairs(const ExampleFiles& files, Session& session) {
  const Document filtered = read_example(files.filtered, session);
  std::optional<Document> unfiltered;
  if (!files.unfiltered.empty()) unfiltered = read_example(files.unfiltered, session);
  return at_place({display_name(files.filtered)},
                  [&] { return example_pairs(unfiltered ? &*unfiltered : nullptr, filtered); });
}

// Unset: as the drawing needs it.
std::optional<double> parse_scale(std::string_view text) {
  if (text == "auto") return std::nullopt;
  double scale = 0;
  if (!take_number(text, scale) || !text.empty()) {
    throw UsageError("--scale is a number or auto");
  }
  return scale;
}

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

CurveAnalogyParameters checked_parameters(const Settings& settings, std::optional<double> scale) {
  CurveAnalogyParameters parameters = settings.parameters;
  parameters.scale = scale.value_or(1);
  parameters.keep_ends = !settings.loose_ends;
  const std::string usual = settings.synthesize ? "translate" : "rotate";
  const std::string& invariance = settings.invariance.empty() ? usual : settings.invariance;
  if (invariance == "translate") parameters.invariance = Invariance::kTranslate;
  if (settings.method == "greedy" || settings.faithful) parameters.method = AnalogyMethod::kGreedy;
  parameters.search = search_parameters(settings);
  try {
    validate(parameters);
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
  return parameters;
}

StyleExample read_style(std::string name, const ExampleFiles& files, const Settings& settings,
                        Session& session) {
  const std::optional<double> scale =
      parse_scale(files.scale.empty() ? settings.scale : files.scale);
  StyleExample style{std::move(name), {}, checked_parameters(settings, scale), !scale};
  style.pairs = read_pairs(files, session);
  return style;
}

StyleSet read_styles(const Settings& settings, Session& session) {
  std::vector<StyleOption> options;
  for (const std::string& text : settings.styles) options.push_back(parse_style_option(text));
  const bool has_rest = !settings.filtered.empty();
  if (!has_rest && (options.empty() || !settings.unfiltered.empty())) {
    throw UsageError("give an example of the style: --filtered FILE, or --style WHAT=FILE");
  }
  std::optional<StyleExample> rest;
  if (has_rest) {
    rest = read_style("the style", {settings.unfiltered, settings.filtered, {}}, settings, session);
  }
  StyleSet styles(std::move(rest));
  for (StyleOption& option : options) {
    styles.add(std::move(option.part),
               read_style("--style " + option.what, option.files, settings, session));
  }
  return styles;
}

// Warnings of the library know a line; the file is known here.
WarningHandler warnings_from(const std::string& input, Session& session) {
  return [&session, file = display_name(input)](const Warning& warning) {
    session.warn({{file, warning.place.line}, warning.id, warning.message});
  };
}

int variant_count(const Settings& settings) {
  const int count = settings.variants ? whole_number(*settings.variants, "--variants") : 1;
  if (count < 1) throw UsageError("--variants is 1 or more");
  return count;
}

// What the outputs of `render -o '{name}.png'` are told apart by.
std::string variant_name(const std::string& name, int number) {
  return (name.empty() ? "unnamed" : name) + '-' + std::to_string(number);
}

// Makes a curve from the example alone.
void synthesize(const Settings& settings, Session& session) {
  const auto refuse = [](bool given, const char* option) {
    if (given) throw UsageError(std::string("--synthesize does not go with ") + option);
  };
  refuse(!settings.styles.empty(), "--style; give the example as --filtered FILE");
  refuse(!settings.unfiltered.empty(), "--unfiltered");
  refuse(settings.method == "greedy" || settings.faithful, "--method greedy and --faithful");
  refuse(settings.inputs != std::vector<std::string>{"-"}, "an input");
  const std::optional<double> scale = parse_scale(settings.scale);
  refuse(!scale, "--scale auto");
  if (settings.filtered.empty()) throw UsageError("give an example of the style: --filtered FILE");
  if (!(*settings.synthesize > 0)) throw UsageError("--synthesize must be above 0");

  const int variants = variant_count(settings);
  const CurveAnalogyParameters parameters = checked_parameters(settings, scale);
  const Document example = read_example(settings.filtered, session);
  OutputFile output(settings.output);
  at_place({display_name(settings.filtered)}, [&] {
    const CurveSynthesis style(synthesis_examples(example), parameters);
    for (int i = 0; i < variants; ++i) {
      Document document =
          synthesized_document(style, example, *settings.synthesize, static_cast<std::uint64_t>(i));
      document.header.history = {session.history()};
      if (settings.variants) document.header.name = variant_name(document.header.name, i + 1);
      write_document(output, document);
    }
  });
  output.commit();
}

void run(const Settings& settings, Session& session) {
  if (settings.synthesize) return synthesize(settings, session);
  const int variants = variant_count(settings);
  StyleSet styles = read_styles(settings, session);
  OutputFile output(settings.output);
  for (const std::string& name : settings.inputs) {
    DocumentInput input(name, session.warning_handler());
    Document document;
    while (input.read(document)) {
      DrawingOptions options{settings.threads, session.progress_handler(),
                             warnings_from(name, session)};
      const StylePlan plan = styles.plan(document, options.warn);
      for (int i = 0; i < variants; ++i) {
        Document variant = document;
        if (settings.variants) variant.header.name = variant_name(document.header.name, i + 1);
        variant.header.history.push_back(session.history());
        options.variant = static_cast<std::uint64_t>(i);
        draw_again(variant, plan, options);
        write_document(output, variant);
        options.warn = {};  // the first has said it
      }
    }
  }
  output.commit();
}

Command describe(Settings& settings) {
  CurveAnalogyParameters& p = settings.parameters;
  return {
      .name = "curve-analogy",
      .summary = "draw curves in the style of an example",
      .synopsis = {"svg2curves plan.svg | curve-analogy --filtered wavy.svg | render -o plan.png",
                   "curve-analogy --unfiltered plain.svg --filtered wavy.svg --seed 7 plan.svg",
                   "curve-analogy --style grass=plain.svg:grass.svg --style .sea=wavy.svg bay.svg",
                   "curve-analogy --filtered coast.svg --synthesize 4000 | render -o new.png",
                   "curve-analogy --filtered loops.svg --scale auto *.svg | curves2svg"},
      .options =
          {{"--filtered", "FILE", "the example: lines drawn in the style", &settings.filtered,
            HistoryUse::kFile},
           {"--unfiltered", "FILE", "the same lines, drawn plainly", &settings.unfiltered,
            HistoryUse::kFile},
           {"--style", "WHAT=FILES",
            "a style for a class, layer, id or element: [UNFILTERED:]FILTERED[@SCALE]",
            &settings.styles, HistoryUse::kFilesOf},
           {"--synthesize", "PX", "make a curve of this length from the example alone",
            &settings.synthesize},
           {"--seed", "N", "another number draws other lines in the same style", &p.seed},
           {"--variants", "N", "so many of each drawing, one with each seed from --seed on",
            &settings.variants},
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
           {"--smoothing", "N", "feature sizes over which lines lose their own detail",
            &p.smoothing},
           {"--smallest-scale", "FACTOR", "how small the style may get where there is no room",
            &p.smallest_scale},
           {"--corner-angle", "DEGREES", "lines that turn more sharply have a corner there",
            &p.corner_angle},
           {"--loose-ends", "", "do not hold the ends of lines in their places",
            &settings.loose_ends},
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
           {"--w-offset", "W", "weight of the offset from the line (greedy)",
            &settings.offset_weight},
           {"--w-delta", "W", "weight of tangents (greedy)", &settings.tangent_weight},
           {"--w-coarse", "W", "weight of the level above (greedy)", &settings.coarse_weight},
           {"--kappa", "K", "what it costs to leave a copied piece (greedy)", &settings.coherence},
           {"--epsilon", "E", "how much worse than the best may be chosen (greedy)",
            &settings.epsilon},
           {"--delta-t", "N", "spacings in a step of the first pass (greedy)", &settings.step},
           threads_option(settings.threads),
           {"--output,-o", "FILE", "write here rather than to stdout", &settings.output,
            HistoryUse::kLeftOut}},
      .inputs = &settings.inputs,
      .run = [&settings](Session& session) { run(settings, session); }};
}

}  // namespace
}  // namespace libstyle

int main(int argc, char** argv) {
  libstyle::Settings settings;
  return libstyle::run_command(argc, argv, libstyle::describe(settings));
}
