// SPDX-License-Identifier: Apache-2.0
// svg2curves: SVG drawings as a stream of curves.
#include <fmt/ranges.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "converters/common/batch.h"
#include "converters/common/command.h"
#include "converters/common/files.h"
#include "converters/svg/svg_reader.h"
#include "libstyle/curves/path_edits.h"
#include "libstyle/curves/selection.h"
#include "libstyle/curves/writer.h"

namespace libstyle {
namespace {

struct Settings {
  std::vector<std::string> inputs;
  std::string output = "-";
  std::string style_sheet;
  std::vector<std::string> select;
  bool split = false;
  std::optional<double> flatten;
  bool strict = false;
  BatchSettings batch;
};

std::string read_text(const std::string& input, std::size_t limit) {
  return read_all(*open_input(input), limit, display_name(input));
}

// What is done to each drawing after it was read.
struct Edits {
  std::optional<RecordSelector> select;
  bool split = false;
  std::optional<double> flatten;
};

Edits checked_edits(const Settings& settings) {
  Edits edits{std::nullopt, settings.split, settings.flatten};
  if (!settings.select.empty()) {
    try {
      edits.select.emplace(fmt::format("{}", fmt::join(settings.select, ",")));
    } catch (const Error& error) {
      throw UsageError(std::string("--select: ") + error.what());
    }
  }
  if (edits.flatten && !(*edits.flatten > 0)) throw UsageError("--flatten must be above 0");
  return edits;
}

void apply(const Edits& edits, Document& document, const std::string& file,
           const WarningHandler& warn) {
  if (edits.select && !keep_selected(document, *edits.select)) {
    warn({{file}, "", "--select: nothing in the drawing is called so"});
  }
  if (edits.split) split_subpaths(document);
  if (edits.flatten) flatten_paths(document, *edits.flatten, file);
}

// A drawing on its way through the program.
struct Drawing {
  std::string input;
  std::string text;    // SVG
  std::string curves;  // what comes out
};

std::string convert(Drawing& drawing, const svg::SvgReadOptions& options, const Edits& edits,
                    const std::string& history, const WarningHandler& warn) {
  const std::string name = display_name(drawing.input);
  Document document = svg::read_svg(std::move(drawing.text), name, options, warn);
  apply(edits, document, name, warn);
  document.header.name = document_name(drawing.input);
  document.header.history.push_back(history);
  TextSink curves;
  at_place({name}, [&] { write_document(curves, document); });
  return std::move(curves.text);
}

void run(const Settings& settings, Session& session) {
  const Edits edits = checked_edits(settings);
  svg::SvgReadOptions options;
  if (!settings.style_sheet.empty()) {
    options.style_sheet = read_text(settings.style_sheet, options.limits.xml.bytes);
  }
  OutputFile output(settings.output);
  bool is_empty = true;
  auto next = settings.inputs.begin();
  run_batch<Drawing>(settings.batch, session,
                     {.read =
                          [&](Drawing& drawing) {
                            if (next == settings.inputs.end()) return false;
                            drawing.input = *next++;
                            drawing.text = read_text(drawing.input, options.limits.xml.bytes);
                            return true;
                          },
                      .work =
                          [&](Drawing& drawing, const WarningHandler& warn) {
                            drawing.curves =
                                convert(drawing, options, edits, session.history(), warn);
                          },
                      .finish =
                          [&](Drawing& drawing) {
                            output.write(drawing.curves);
                            is_empty = false;
                          }});
  if (settings.strict && session.warning_count() > 0) {
    throw Error("not everything was carried, and --strict asks for that");
  }
  if (!is_empty) output.commit();
}

Command describe(Settings& settings) {
  return {.name = "svg2curves",
          .summary = "SVG drawings as a stream of curves",
          .synopsis = {"svg2curves plan.svg > plan.curves",
                       "svg2curves icons/*.svg | render -o 'out/{name}.png'",
                       "svg2curves --strict --stylesheet print.css < plan.svg",
                       "svg2curves --keep-going --report icons.json icons/*.svg > icons.curves"},
          .options = {{"--output,-o", "FILE", "write here rather than to stdout", &settings.output,
                       HistoryUse::kLeftOut},
                      {"--stylesheet", "FILE", "CSS that comes after that of the drawings",
                       &settings.style_sheet, HistoryUse::kFile},
                      {"--select", "WHAT",
                       "keep only these: #id, .class, rect, layer:Name, with commas between",
                       &settings.select},
                      {"--split", "", "make a path of each subpath", &settings.split},
                      {"--flatten", "PX", "make polylines that are at most so far from the curves",
                       &settings.flatten},
                      {"--strict", "", "fail when anything is warned about", &settings.strict,
                       HistoryUse::kLeftOut},
                      keep_going_option(settings.batch.keep_going),
                      threads_option(settings.batch.threads)},
          .inputs = &settings.inputs,
          .run = [&settings](Session& session) { run(settings, session); },
          .has_report = true};
}

}  // namespace
}  // namespace libstyle

int main(int argc, char** argv) {
  libstyle::Settings settings;
  return libstyle::run_command(argc, argv, libstyle::describe(settings));
}
