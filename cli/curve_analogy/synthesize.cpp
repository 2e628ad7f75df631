// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/synthesize.h"

#include <cstdint>
#include <string>
#include <vector>

#include "cli/curve_analogy/examples.h"
#include "cli/curve_analogy/explain.h"
#include "cli/curve_analogy/measures_report.h"
#include "cli/curve_analogy/through_option.h"
#include "converters/common/command.h"
#include "converters/common/files.h"
#include "libstyle/analogy/synthesis_document.h"
#include "libstyle/base/error.h"
#include "libstyle/curves/writer.h"

namespace libstyle {
namespace {

void refuse_other_work(const Settings& settings) {
  const auto refuse = [](bool given, const char* option) {
    if (given) throw UsageError(std::string("--synthesize does not go with ") + option);
  };
  refuse(!settings.styles.empty(), "--style; give the example as --filtered FILE");
  refuse(!settings.unfiltered.empty(), "--unfiltered");
  refuse(settings.inputs != std::vector<std::string>{"-"}, "an input");
  for (const char* option : {"--frames", "--coherence", "--shape-weight", "--smoothing",
                             "--smallest-scale", "--corner-angle", "--loose-ends"}) {
    refuse(settings.is_given(option), option);
  }
  if (!(*settings.synthesize > 0)) throw UsageError("--synthesize must be above 0");
}

// The measures of one new line.
StyleMeasures measure(const SynthesizedCurve& drawn, const Document& document,
                      const Example& example) {
  StyledCurve curve;
  curve.curve = drawn.curve;
  curve.runs = drawn.runs;
  const Path& written = std::get<PathRecord>(document.records.front()).path;
  CurveMeasure measure = measure_new_curve(curve, written);
  return summarize({&measure, 1}, example);
}

std::vector<CurveConstraint> read_constraints(const Settings& settings) {
  std::vector<CurveConstraint> result;
  for (const std::string& text : settings.through) {
    result.push_back(parse_through_option_of_new_line(text));
  }
  return result;
}

}  // namespace

void synthesize(const Settings& settings, Session& session) {
  refuse_other_work(settings);
  const std::vector<CurveConstraint> constraints = read_constraints(settings);
  const int variants = settings.document_count();
  const StyleSource source = read_style_source(settings, session);
  refuse_idle_symbols(settings, source.settings.is_greedy());
  if (!source.scale()) throw UsageError("--synthesize does not go with --scale auto");
  const CurveAnalogyParameters parameters = source.parameters();
  OutputFile output(settings.output);
  at_place({source.file}, [&] {
    const CurveSynthesis style(synthesis_examples(source.pairs), parameters);
    if (settings.explain) {
      session.message(explanation(source.file, style.summary(), {.makes_new_lines = true}));
    }
    for (int i = 0; i < variants; ++i) {
      const auto variant = static_cast<std::uint64_t>(i);
      const SynthesizedCurve drawn = style.draw(*settings.synthesize, 0, variant, constraints);
      Document document = synthesized_document(style, drawn, source.filtered);
      document.header.history = {session.history()};
      if (settings.variants) document.header.name = variant_name(document.header.name, i + 1);
      write_document(output, document);
      if (!session.has_report()) continue;
      const StyleMeasures measures = measure(drawn, document, style.example());
      session.note(kDrawings,
                   to_json({{},
                            0,
                            document.header.name,
                            variant,
                            {style_report("the style", style.summary(), measures, variant)}}));
    }
  });
  output.commit();
}

}  // namespace libstyle
