// SPDX-License-Identifier: Apache-2.0
// svg2curves: SVG drawings as a stream of curves.
#include <fmt/ranges.h>

#include <optional>
#include <string>
#include <vector>

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

Document convert(const std::string& input, const svg::SvgReadOptions& options, const Edits& edits,
                 Session& session) {
  Document document = svg::read_svg(read_text(input, options.limits.xml.bytes), display_name(input),
                                    options, session.warning_handler());
  apply(edits, document, display_name(input), session.warning_handler());
  document.header.name = document_name(input);
  document.header.history.push_back(session.history());
  return document;
}

void run(const Settings& settings, Session& session) {
  const Edits edits = checked_edits(settings);
  svg::SvgReadOptions options;
  if (!settings.style_sheet.empty()) {
    options.style_sheet = read_text(settings.style_sheet, options.limits.xml.bytes);
  }
  OutputFile output(settings.output);
  for (const std::string& input : settings.inputs) {
    write_document(output, convert(input, options, edits, session));
  }
  if (settings.strict && session.warning_count() > 0) {
    throw Error("not everything was carried, and --strict asks for that");
  }
  output.commit();
}

Command describe(Settings& settings) {
  return {.name = "svg2curves",
          .summary = "SVG drawings as a stream of curves",
          .synopsis = {"svg2curves plan.svg > plan.curves",
                       "svg2curves icons/*.svg | render -o 'out/{name}.png'",
                       "svg2curves --strict --stylesheet print.css < plan.svg"},
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
