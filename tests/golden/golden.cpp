// SPDX-License-Identifier: Apache-2.0
// golden: one picture test. Draws a drawing or curves on white, as `render` does, and compares with
// the picture beside it. Where they differ it leaves expected, difference and actual side by side
// in the build tree. With LIBSTYLE_BLESS set it writes the expected picture instead, and still
// fails: no run both changes what is expected and passes.
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "converters/cairo/picture.h"
#include "converters/common/command.h"
#include "converters/common/files.h"
#include "converters/svg/document_input.h"
#include "libstyle/base/error.h"
#include "tests/support/pixdiff.h"

namespace libstyle {
namespace {

struct Settings {
  std::string name;
  std::string input;
  std::string panels;
  DiffBounds bounds;
};

Raster draw(const std::string& input, Session& session) {
  Document document;
  DocumentInput documents(input, session.warning_handler());
  if (!documents.read(document)) throw Error(input + ": holds no document");
  TextSink png;
  PictureSettings settings;
  settings.background = Color{255, 255, 255};
  Picture picture(png, settings, session.warning_handler());
  picture.add(document);
  picture.finish();
  return decode_png(png.text);
}

void run(const Settings& settings, Session& session) {
  const std::filesystem::path expected_name =
      std::filesystem::path(settings.input).replace_extension(".png");
  const Raster actual = draw(settings.input, session);
  if (session.warning_count() > 0) throw Error(settings.input + ": a case draws without warnings");
  if (std::getenv("LIBSTYLE_BLESS")) {
    save_image(expected_name, actual);
    throw Error("blessed " + expected_name.string() + "; look at it, then run the test again");
  }
  if (!std::filesystem::exists(expected_name)) {
    throw Error("there is no picture yet; to make it: script/bless " + settings.name);
  }
  const Raster expected = load_image(expected_name);
  const DiffResult result = compare(expected, actual, settings.bounds);
  if (result.passed) return;
  std::filesystem::create_directories(std::filesystem::path(settings.panels).parent_path());
  save_image(settings.panels, three_panels(expected, actual, settings.bounds));
  throw Error(result.summary + "; see " + settings.panels +
              "; if the new picture is right: script/bless " + settings.name);
}

Command describe(Settings& settings) {
  DiffBounds& bounds = settings.bounds;
  return {.name = "golden",
          .summary = "one picture test",
          .synopsis = {"golden --name golden/stroke/caps --input caps.curves --panels caps.png"},
          .options = {{"--name", "NAME", "the test's name", &settings.name},
                      {"--input", "FILE", "a drawing or curves, a picture of it beside it",
                       &settings.input},
                      {"--panels", "FILE", "where to leave what differs", &settings.panels},
                      {"--bound", "N", "how far a channel may differ", &bounds.per_channel},
                      {"--share", "SHARE", "how many of all pixels may differ by more",
                       &bounds.bad_share},
                      {"--stop", "N", "how far no channel may differ", &bounds.hard_stop}},
          .run = [&settings](Session& session) { run(settings, session); }};
}

}  // namespace
}  // namespace libstyle

int main(int argc, char** argv) {
  libstyle::Settings settings;
  return libstyle::run_command(argc, argv, libstyle::describe(settings));
}
