// SPDX-License-Identifier: Apache-2.0
// render: curves as PNG, SVG or PDF.
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "converters/cairo/picture.h"
#include "converters/common/batch.h"
#include "converters/common/command.h"
#include "converters/common/document_files.h"
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
  BatchSettings batch;
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

// A document on its way through the program.
struct Drawing {
  TakenDocument taken;
  Document document;
  DocumentFile file;  // its picture, if that is a file of its own
};

// Where pictures go.
class Pictures {
 public:
  virtual ~Pictures() = default;

  // Any number of calls at a time.
  virtual void draw(Drawing& drawing, const WarningHandler& warn) const = 0;
  // In the order of the stream.
  virtual void write(Drawing& drawing) = 0;
  // After the last.
  virtual void finish() = 0;
};

// Each document is a file.
class PictureFiles final : public Pictures {
 public:
  PictureFiles(const std::string& output, const PictureSettings& settings)
      : settings_(settings), files_(output, ", or use PDF, which takes one a page") {}

  void draw(Drawing& drawing, const WarningHandler& warn) const override {
    TextSink bytes;
    Picture picture(bytes, settings_, warn);
    picture.add(drawing.document, drawing.file.place.file);
    picture.finish();
    drawing.file.bytes = std::move(bytes.text);
  }

  void write(Drawing& drawing) override { files_.add(std::move(drawing.file)); }

  void finish() override { files_.finish(); }

 private:
  const PictureSettings settings_;
  DocumentFiles files_;
};

// Each document is a page of one file, which Cairo draws one after the other.
class PicturePages final : public Pictures {
 public:
  PicturePages(const std::string& output, const PictureSettings& settings,
               const WarningHandler& warn)
      : file_(output), picture_(file_, settings, warn) {}

  void draw(Drawing&, const WarningHandler&) const override {}

  void write(Drawing& drawing) override {
    picture_.add(drawing.document, drawing.file.place.file);
    is_empty_ = false;
  }

  void finish() override {
    if (is_empty_) return;
    picture_.finish();
    file_.commit();
  }

 private:
  OutputFile file_;
  Picture picture_;
  bool is_empty_ = true;
};

std::unique_ptr<Pictures> open_pictures(const Settings& settings, Session& session) {
  const PictureSettings pictures = picture_settings(settings);
  if (pictures.format == PictureFormat::kPdf && !OutputPattern(settings.output).takes_several()) {
    return std::make_unique<PicturePages>(settings.output, pictures, session.warning_handler());
  }
  return std::make_unique<PictureFiles>(settings.output, pictures);
}

void draw(Drawing& drawing, const Pictures& pictures, const WarningHandler& warn) {
  drawing.file.place.file = display_name(drawing.taken.input);
  drawing.file.number = drawing.taken.number;
  drawing.document = to_document(std::move(drawing.taken), warn);
  drawing.file.place.line = drawing.document.header.line;
  drawing.file.name = drawing.document.header.name;
  pictures.draw(drawing, warn);
}

void run(const Settings& settings, Session& session) {
  const std::unique_ptr<Pictures> pictures = open_pictures(settings, session);
  DocumentInputs inputs(settings.inputs);
  run_batch<Drawing>(settings.batch, session,
                     {.read = [&](Drawing& drawing) { return inputs.take(drawing.taken); },
                      .work = [&](Drawing& drawing,
                                  const WarningHandler& warn) { draw(drawing, *pictures, warn); },
                      .finish = [&](Drawing& drawing) { pictures->write(drawing); }});
  pictures->finish();
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
                      {"--background", "COLOR", "a CSS color to draw on", &settings.background},
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
