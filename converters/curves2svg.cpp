// SPDX-License-Identifier: Apache-2.0
// curves2svg: curves as SVG that draws the same and that people can edit.
#include <string>
#include <utility>
#include <vector>

#include "converters/common/batch.h"
#include "converters/common/command.h"
#include "converters/common/document_files.h"
#include "converters/common/files.h"
#include "converters/svg/document_input.h"
#include "converters/svg/svg_writer.h"

namespace libstyle {
namespace {

struct Settings {
  std::vector<std::string> inputs;
  std::string output = "-";
  BatchSettings batch;
};

// A document on its way through the program.
struct Drawing {
  TakenDocument taken;
  DocumentFile file;  // what comes out
};

void convert(Drawing& drawing, const std::string& history, const WarningHandler& warn) {
  drawing.file.place.file = display_name(drawing.taken.input);
  drawing.file.number = drawing.taken.number;
  Document document = to_document(std::move(drawing.taken), warn);
  drawing.file.place.line = document.header.line;
  drawing.file.name = document.header.name;
  document.header.history.push_back(history);
  TextSink svg;
  svg::write_svg(svg, document, [&](Warning warning) {
    warning.place.file = drawing.file.place.file;
    warn(warning);
  });
  drawing.file.bytes = std::move(svg.text);
}

void run(const Settings& settings, Session& session) {
  DocumentInputs inputs(settings.inputs);
  DocumentFiles files(settings.output);
  run_batch<Drawing>(
      settings.batch, session,
      {.read = [&](Drawing& drawing) { return inputs.take(drawing.taken); },
       .work = [&](Drawing& drawing,
                   const WarningHandler& warn) { convert(drawing, session.history(), warn); },
       .finish = [&](Drawing& drawing) { files.add(std::move(drawing.file)); }});
  files.finish();
}

Command describe(Settings& settings) {
  return {
      .name = "curves2svg",
      .summary = "curves as SVG that people can edit",
      .synopsis =
          {"curves2svg plan.curves > plan.svg",
           "svg2curves plan.svg | curve-analogy --filtered shaky.svg | curves2svg > shaky-plan.svg",
           "curves2svg --output 'out/{name}.svg' all.curves"},
      .options = {{"--output,-o", "FILE",
                   "write here; {name} and {number} stand for those of the document",
                   &settings.output, HistoryUse::kLeftOut},
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
