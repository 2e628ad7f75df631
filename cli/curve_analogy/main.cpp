// SPDX-License-Identifier: Apache-2.0
// curve-analogy: the curves of a drawing in the style of an example.
#include "cli/curve_analogy/draw.h"
#include "cli/curve_analogy/settings.h"
#include "cli/curve_analogy/style_file.h"
#include "cli/curve_analogy/synthesize.h"
#include "converters/common/command.h"

namespace libstyle {
namespace {

std::vector<Option> options(Settings& settings) {
  std::vector<Option> result = {
      {"--filtered", "FILE", "the example: lines drawn in the style", &settings.filtered,
       HistoryUse::kFile},
      {"--unfiltered", "FILE", "the same lines, drawn plainly", &settings.unfiltered,
       HistoryUse::kFile},
      {"--style", "WHAT=FILES",
       "a style for a class, layer, id or element: [UNFILTERED:]FILTERED[@SCALE]", &settings.styles,
       HistoryUse::kFilesOf},
      {"--style-file", "FILE", "a style of --save-style, instead of an example",
       &settings.style_file, HistoryUse::kFile},
      {"--save-style", "FILE", "keep the example and the options as a style, and end",
       &settings.save_style, HistoryUse::kLeftOut},
      {"--through", "PLACE",
       "a place that a line passes, or is drawn towards: CURVE=X,Y[@T][*WEIGHT]",
       &settings.through},
      {"--synthesize", "PX", "make a curve of this length from the example alone",
       &settings.synthesize},
      {"--variants", "N", "so many of each drawing, one with each seed from --seed on",
       &settings.variants},
      {"--frames", "N", "so many frames of each drawing, for lines that tremble", &settings.frames},
      {"--coherence", "C", "how much of a frame stays in the next, 0 to 1",
       &settings.frame_coherence}};
  for (Option& option : style_options(settings)) result.push_back(std::move(option));
  for (Option& option :
       std::vector<Option>{{"--explain", "", "say what was chosen for each style, and why",
                            &settings.explain, HistoryUse::kLeftOut},
                           keep_going_option(settings.keep_going),
                           threads_option(settings.threads),
                           {"--output,-o", "FILE", "write here rather than to stdout",
                            &settings.output, HistoryUse::kLeftOut}}) {
    result.push_back(std::move(option));
  }
  return result;
}

void run(const Settings& settings, Session& session) {
  if (!settings.save_style.empty()) return save_style(settings, session);
  settings.synthesize ? synthesize(settings, session) : draw(settings, session);
}

Command describe(Settings& settings) {
  return {
      .name = "curve-analogy",
      .summary = "draw curves in the style of an example",
      .synopsis =
          {"svg2curves plan.svg | curve-analogy --filtered wavy.svg | render -o plan.png",
           "curve-analogy --unfiltered plain.svg --filtered wavy.svg --seed 7 plan.svg",
           "curve-analogy --style grass=plain.svg:grass.svg --style .sea=wavy.svg bay.svg",
           "curve-analogy --filtered wavy.svg --through road=120,80 plan.svg",
           "curve-analogy --filtered coast.svg --synthesize 4000 | render -o new.png",
           "curve-analogy --filtered loops.svg --scale auto *.svg | curves2svg",
           "curve-analogy --filtered shaky.svg --frames 12 harbour.svg | render -o '{name}.png'",
           "curve-analogy --filtered wavy.svg --scale 2 --save-style wavy.style"},
      .options = options(settings),
      .inputs = &settings.inputs,
      .run = [&settings](Session& session) { run(settings, session); },
      .has_report = true,
      .given = &settings.given};
}

}  // namespace
}  // namespace libstyle

int main(int argc, char** argv) {
  libstyle::Settings settings;
  return libstyle::run_command(argc, argv, libstyle::describe(settings));
}
