// SPDX-License-Identifier: Apache-2.0
// pixdiff: whether two PNG files show the same.
#include <iostream>
#include <string>
#include <vector>

#include "converters/common/command.h"
#include "libstyle/base/error.h"
#include "tests/support/pixdiff.h"

namespace libstyle {
namespace {

struct Settings {
  std::vector<std::string> inputs;
  DiffBounds bounds;
  bool pixel_larger = false;
  std::string panels;
};

void run(Settings& settings) {
  settings.bounds.size_slack = settings.pixel_larger ? 1 : 0;
  if (settings.inputs.size() != 2) throw UsageError("name two pictures: EXPECTED ACTUAL");
  const Raster expected = load_image(settings.inputs[0]);
  const Raster actual = load_image(settings.inputs[1]);
  const DiffResult result = compare(expected, actual, settings.bounds);
  std::cout << result.summary << "\n";
  if (result.passed) return;
  if (!settings.panels.empty()) {
    save_image(settings.panels, three_panels(expected, actual, settings.bounds));
  }
  throw Error(settings.inputs[1] + ": not the picture that was expected");
}

Command describe(Settings& settings) {
  DiffBounds& bounds = settings.bounds;
  return {
      .name = "pixdiff",
      .summary = "whether two PNG files show the same",
      .synopsis = {"pixdiff expected.png actual.png",
                   "pixdiff --envelope --bound 24 --share 0.0005 a.png b.png"},
      .options = {{"--bound", "N", "how far a channel may differ, 0 to 255", &bounds.per_channel},
                  {"--share", "SHARE", "how many of all pixels may differ by more, 0 to 1",
                   &bounds.bad_share},
                  {"--stop", "N", "how far no channel may differ", &bounds.hard_stop},
                  {"--envelope", "", "compare with the 3x3 neighbours in the other picture",
                   &bounds.envelope},
                  {"--pixel-larger", "", "one picture may be a pixel larger than the other",
                   &settings.pixel_larger},
                  {"--panels", "FILE", "on failure, write expected, difference, actual here",
                   &settings.panels}},
      .inputs = &settings.inputs,
      .run = [&settings](Session&) { run(settings); }};
}

}  // namespace
}  // namespace libstyle

int main(int argc, char** argv) {
  libstyle::Settings settings;
  return libstyle::run_command(argc, argv, libstyle::describe(settings));
}
