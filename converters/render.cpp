// SPDX-License-Identifier: Apache-2.0
// render: curves as PNG, SVG or PDF.
#include <optional>
#include <string>
#include <vector>

#include "converters/cairo/picture.h"
#include "converters/common/command.h"
#include "converters/common/files.h"
#include "converters/common/output_pattern.h"
#include "converters/svg/css_color.h"
#include "converters/svg/document_input.h"
#include "libstyle/base/error.h"

namespace libstyle {
namespace {

struct Settings {
  std::vector<std::string> inputs;
  std::string output = "-";
  std::string format;
  std::string background;
  std::optional<double> width;
  std::optional<double> height;
  double scale = 1;
};

std::optional<Color> parse_background(const std::string& text) {
  if (text.empty() || text == "none") return std::nullopt;
  const auto parsed = svg::parse_css_color(text);
  if (!parsed) throw UsageError("--background: \"" + text + "\" is not a CSS color");
  Color color = parsed->color;
  color.alpha = static_cast<std::uint8_t>(parsed->alpha * 255 + 0.5);
  return color;
}

PictureFormat choose_format(const Settings& settings) {
  if (!settings.format.empty()) return *picture_format("." + settings.format);
  if (settings.output == "-") return PictureFormat::kPng;
  if (const auto format = picture_format(settings.output)) return *format;
  throw UsageError("--output: \"" + settings.output +
                   "\" does not end in .png, .svg or .pdf; say which with --format");
}

PictureSettings picture_settings(const Settings& settings) {
  const auto check = [](std::optional<double> number, const char* option) {
    if (number && !(*number > 0)) throw UsageError(std::string(option) + " must be above 0");
  };
  check(settings.width, "--width");
  check(settings.height, "--height");
  check(settings.scale, "--scale");
  return {choose_format(settings),
          {settings.width, settings.height, settings.scale},
          parse_background(settings.background)};
}

// Where pictures go: one file for all, or one for each document.
class PictureFiles {
 public:
  PictureFiles(const std::string& output, const PictureSettings& settings,
               const WarningHandler& warn)
      : names_(output), settings_(settings), warn_(warn) {}

  void add(const Document& document, const std::string& input) {
    if (names_.takes_several() || !picture_) begin(names_.next(document.header.name));
    picture_->add(document, display_name(input));
    if (names_.takes_several()) end();
  }

  void finish() {
    if (picture_) end();
  }

 private:
  void begin(const std::string& name) {
    file_.emplace(name);
    picture_.emplace(*file_, settings_, warn_);
  }

  void end() {
    picture_->finish();
    file_->commit();
    picture_.reset();
    file_.reset();
  }

  OutputPattern names_;
  const PictureSettings settings_;
  const WarningHandler warn_;
  std::optional<OutputFile> file_;
  std::optional<Picture> picture_;
};

void run(const Settings& settings, Session& session) {
  const WarningHandler warn = session.warning_handler();
  PictureFiles pictures(settings.output, picture_settings(settings), warn);
  Document document;
  for (const std::string& input : settings.inputs) {
    DocumentInput documents(input, warn);
    if (!documents.read(document)) {
      throw Error({display_name(input)}, "holds no document; a document begins with a header line");
    }
    do {
      pictures.add(document, input);
    } while (documents.read(document));
  }
  pictures.finish();
}

Command describe(Settings& settings) {
  return {.name = "render",
          .summary = "draw curves as PNG, SVG or PDF",
          .synopsis = {"svg2curves plan.svg | render -o plan.png",
                       "render --width 800 --background white --output plan.png plan.svg",
                       "svg2curves *.svg | render --output 'out/{name}.png'",
                       "cat all.curves | render --format pdf > all.pdf"},
          .options = {{"--output,-o", "FILE",
                       "write here; {name} and {number} stand for those of the document",
                       &settings.output, HistoryUse::kLeftOut},
                      {"--format",
                       "FORMAT",
                       "what to write when the name of the output does not say it",
                       &settings.format,
                       HistoryUse::kRecorded,
                       {"png", "svg", "pdf"}},
                      {"--width,-w", "PX",
                       "the width of the picture, or the most with --height too", &settings.width},
                      {"--height,-h", "PX",
                       "the height of the picture, or the most with --width too", &settings.height},
                      {"--scale", "FACTOR", "how large a page is drawn when neither is given",
                       &settings.scale},
                      {"--background", "COLOR", "a CSS color to draw on", &settings.background}},
          .inputs = &settings.inputs,
          .run = [&settings](Session& session) { run(settings, session); }};
}

}  // namespace
}  // namespace libstyle

int main(int argc, char** argv) {
  libstyle::Settings settings;
  return libstyle::run_command(argc, argv, libstyle::describe(settings));
}
