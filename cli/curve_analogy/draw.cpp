// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/draw.h"

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/curve_analogy/examples.h"
#include "cli/curve_analogy/explain.h"
#include "cli/curve_analogy/measures_report.h"
#include "cli/curve_analogy/through_option.h"
#include "converters/common/batch.h"
#include "converters/common/files.h"
#include "converters/svg/document_input.h"
#include "libstyle/analogy/drawing.h"
#include "libstyle/base/error.h"
#include "libstyle/curves/writer.h"

namespace libstyle {
namespace {

// A document on its way through the program.
struct Drawing {
  TakenDocument taken;
  std::vector<std::string> explanations;  // of its styles
  TextSink curves;                        // of all variants, or frames
  std::vector<JsonObject> reports;        // of each
};

std::vector<std::string> explain(const StylePlan& plan) {
  std::vector<std::string> result;
  for (const StylePlan::Style& style : plan.styles) {
    if (!style.analogy) continue;
    result.push_back(explanation(style.name, style.analogy->summary(),
                                 {.has_fitting_scale = style.has_fitting_scale}));
  }
  return result;
}

std::vector<JsonObject> style_reports(const StylePlan& plan,
                                      const std::vector<StyleMeasures>& measures,
                                      std::uint64_t variant) {
  std::vector<JsonObject> result;
  for (std::size_t i = 0; i < plan.styles.size(); ++i) {
    const StylePlan::Style& style = plan.styles[i];
    if (!style.analogy) continue;
    result.push_back(style_report(style.name, style.analogy->summary(), measures[i], variant));
  }
  return result;
}

std::vector<AskedConstraint> read_constraints(const Settings& settings) {
  std::vector<AskedConstraint> result;
  for (const std::string& text : settings.through) result.push_back(parse_through_option(text));
  return result;
}

// Errors of the library know a line as well.
void draw_document(Document& document, const std::string& file, const StylePlan& plan,
                   const DrawingOptions& options) {
  try {
    draw_again(document, plan, options);
  } catch (const Error& error) {
    throw Error({file, error.place().line}, error.message());
  }
}

void draw_variants(Drawing& drawing, StyleSet& styles,
                   const std::vector<AskedConstraint>& constraints, const Settings& settings,
                   const Session& session, const WarningHandler& warn) {
  const std::string file = display_name(drawing.taken.input);
  const Document document = to_document(std::move(drawing.taken), warn);
  // Warnings of the library know a line; the file is known here.
  const WarningHandler warn_in_file = [&](Warning warning) {
    warning.place.file = file;
    warn(warning);
  };
  const StylePlan plan = styles.plan(document, warn_in_file);
  if (settings.explain) drawing.explanations = explain(plan);
  std::vector<StyleMeasures> measures;
  DrawnWalks walks;
  DrawingOptions options{.threads = settings.threads,
                         .progress = session.progress_handler(),
                         .warn = warn_in_file,
                         .walks = settings.frames ? &walks : nullptr,
                         .coherence = settings.coherence_of_frames(),
                         .measures = session.has_report() ? &measures : nullptr,
                         .constraints = constraints};
  for (int i = 0; i < settings.document_count(); ++i) {
    Document variant = document;
    if (settings.is_numbered()) variant.header.name = variant_name(document.header.name, i + 1);
    variant.header.history.push_back(session.history());
    options.variant = static_cast<std::uint64_t>(i);
    draw_document(variant, file, plan, options);
    write_document(drawing.curves, variant);
    options.warn = {};  // the first has said it
    if (!session.has_report()) continue;
    drawing.reports.push_back(
        to_json({file, document.header.line, variant.header.name, options.variant,
                 style_reports(plan, measures, options.variant)}));
  }
}

}  // namespace

void draw(const Settings& settings, Session& session) {
  // Checked before anything is read.
  settings.document_count();
  settings.coherence_of_frames();
  const std::vector<AskedConstraint> constraints = read_constraints(settings);
  StyleSet styles = read_styles(settings, session);
  OutputFile output(settings.output);
  DocumentInputs inputs(settings.inputs);
  std::set<std::string> explained;
  bool is_empty = true;
  // One document at a time: all threads are at its lines.
  run_batch<Drawing>({.keep_going = settings.keep_going, .threads = 1}, session,
                     {.read = [&](Drawing& drawing) { return inputs.take(drawing.taken); },
                      .work =
                          [&](Drawing& drawing, const WarningHandler& warn) {
                            draw_variants(drawing, styles, constraints, settings, session, warn);
                          },
                      .finish =
                          [&](Drawing& drawing) {
                            for (const std::string& text : drawing.explanations) {
                              if (explained.insert(text).second) session.message(text);
                            }
                            output.write(drawing.curves.text);
                            is_empty = false;
                            for (const JsonObject& report : drawing.reports)
                              session.note(kDrawings, report);
                          }});
  if (!is_empty) output.commit();
}

}  // namespace libstyle
