// SPDX-License-Identifier: Apache-2.0
// svg2curves: SVG drawings as a stream of curves.
#include <string>
#include <vector>

#include "converters/common/command.h"
#include "converters/common/files.h"
#include "converters/svg/svg_reader.h"
#include "libstyle/curves/writer.h"

namespace libstyle {
namespace {

struct Settings {
  std::vector<std::string> inputs;
  std::string output = "-";
  std::string style_sheet;
  bool strict = false;
};

std::string read_text(const std::string& input, std::size_t limit) {
  return read_all(*open_input(input), limit, display_name(input));
}

Document convert(const std::string& input, const svg::SvgReadOptions& options, Session& session) {
  Document document = svg::read_svg(read_text(input, options.limits.xml.bytes), display_name(input),
                                    options, session.warning_handler());
  document.header.name = document_name(input);
  document.header.history.push_back(session.history());
  return document;
}

void run(const Settings& settings, Session& session) {
  svg::SvgReadOptions options;
  if (!settings.style_sheet.empty()) {
    options.style_sheet = read_text(settings.style_sheet, options.limits.xml.bytes);
  }
  OutputFile output(settings.output);
  for (const std::string& input : settings.inputs) {
    write_document(output, convert(input, options, session));
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
