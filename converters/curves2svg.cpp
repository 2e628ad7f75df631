// SPDX-License-Identifier: Apache-2.0
// curves2svg: curves as SVG that draws the same and that people can edit.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "converters/common/command.h"
#include "converters/common/files.h"
#include "converters/common/output_pattern.h"
#include "converters/svg/document_input.h"
#include "converters/svg/svg_writer.h"
#include "libstyle/base/error.h"

namespace libstyle {
namespace {

struct Settings {
  std::vector<std::string> inputs;
  std::string output = "-";
};

// Where documents go: each to a file of its own, or the only one to the output. That there is no
// second one must be known before the first is written.
class SvgFiles {
 public:
  SvgFiles(const std::string& output, Session& session) : names_(output), session_(session) {}

  void add(Document document, const std::string& input) {
    document.header.history.push_back(session_.history());
    if (names_.takes_several()) return write(document, input);
    if (only_) {
      throw Error({display_name(input)},
                  "there is a second document, and an SVG file holds one; name several outputs "
                  "with --output 'out/{name}.svg'");
    }
    only_ = std::move(document);
    only_input_ = input;
  }

  void finish(const std::string& last_input) {
    if (names_.takes_several()) return;
    if (!only_) throw Error({display_name(last_input)}, "there is no document to write");
    write(*only_, only_input_);
  }

 private:
  void write(const Document& document, const std::string& input) {
    OutputFile file(names_.next(document.header.name));
    svg::write_svg(file, document, [&](Warning warning) {
      warning.place.file = display_name(input);
      session_.warn(warning);
    });
    file.commit();
  }

  OutputPattern names_;
  Session& session_;
  std::optional<Document> only_;
  std::string only_input_;
};

void run(const Settings& settings, Session& session) {
  SvgFiles files(settings.output, session);
  const std::vector<std::string>& inputs = settings.inputs;
  for (const std::string& input : inputs) {
    DocumentInput documents(input, session.warning_handler());
    Document document;
    while (documents.read(document)) files.add(std::move(document), input);
  }
  files.finish(inputs.back());
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
                   &settings.output, HistoryUse::kLeftOut}},
      .inputs = &settings.inputs,
      .run = [&settings](Session& session) { run(settings, session); }};
}

}  // namespace
}  // namespace libstyle

int main(int argc, char** argv) {
  libstyle::Settings settings;
  return libstyle::run_command(argc, argv, libstyle::describe(settings));
}
