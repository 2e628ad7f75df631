// SPDX-License-Identifier: Apache-2.0
// curve-analogy: the curves of a drawing in the style of an example.
#include "cli/curve_analogy/draw.h"
#include "cli/curve_analogy/settings.h"
#include "cli/curve_analogy/synthesize.h"
#include "converters/common/command.h"

namespace libstyle {
namespace {

Command describe(Settings& settings) {
  CurveAnalogyParameters& p = settings.parameters;
  return {
      .name = "curve-analogy",
      .summary = "draw curves in the style of an example",
      .synopsis =
          {"svg2curves plan.svg | curve-analogy --filtered wavy.svg | render -o plan.png",
           "curve-analogy --unfiltered plain.svg --filtered wavy.svg --seed 7 plan.svg",
           "curve-analogy --style grass=plain.svg:grass.svg --style .sea=wavy.svg bay.svg",
           "curve-analogy --filtered coast.svg --synthesize 4000 | render -o new.png",
           "curve-analogy --filtered loops.svg --scale auto *.svg | curves2svg",
           "curve-analogy --filtered shaky.svg --frames 12 harbour.svg | render -o '{name}.png'"},
      .options =
          {{"--filtered", "FILE", "the example: lines drawn in the style", &settings.filtered,
            HistoryUse::kFile},
           {"--unfiltered", "FILE", "the same lines, drawn plainly", &settings.unfiltered,
            HistoryUse::kFile},
           {"--style", "WHAT=FILES",
            "a style for a class, layer, id or element: [UNFILTERED:]FILTERED[@SCALE]",
            &settings.styles, HistoryUse::kFilesOf},
           {"--synthesize", "PX", "make a curve of this length from the example alone",
            &settings.synthesize},
           {"--seed", "N", "another number draws other lines in the same style", &p.seed},
           {"--variants", "N", "so many of each drawing, one with each seed from --seed on",
            &settings.variants},
           {"--frames", "N", "so many frames of each drawing, for lines that tremble",
            &settings.frames},
           {"--coherence", "C", "how much of a frame stays in the next, 0 to 1",
            &settings.frame_coherence},
           {"--scale", "FACTOR", "the size of the style: a factor, or auto to suit the drawing",
            &settings.scale},
           {"--invariance",
            "KIND",
            "whether the style turns with the lines: rotate or translate",
            &settings.invariance,
            HistoryUse::kRecorded,
            {"rotate", "translate"}},
           {"--shape-weight", "W", "how much the shape of a line decides what is drawn there",
            &p.shape_weight},
           {"--feature-size", "PX", "half the size of a feature of the example", &p.feature_size},
           {"--samples", "N", "how finely the example is cut", &p.samples},
           {"--mean-run", "N", "feature sizes copied from the example in one go", &p.mean_run},
           {"--smoothing", "N", "feature sizes over which lines lose their own detail",
            &p.smoothing},
           {"--smallest-scale", "FACTOR", "how small the style may get where there is no room",
            &p.smallest_scale},
           {"--corner-angle", "DEGREES", "lines that turn more sharply have a corner there",
            &p.corner_angle},
           {"--loose-ends", "", "do not hold the ends of lines in their places",
            &settings.loose_ends},
           {"--method",
            "KIND",
            "chain, or greedy: the paper's search, repaired",
            &settings.method,
            HistoryUse::kRecorded,
            {"chain", "greedy"}},
           {"--faithful", "", "greedy as the paper prints it, but for its misprints",
            &settings.faithful},
           {"--levels", "N", "of the pyramid (greedy)", &settings.levels},
           {"--passes", "N", "refinements of each level (greedy)", &settings.passes},
           {"--neighborhood", "N", "samples of a neighborhood, odd (greedy)",
            &settings.neighborhood_samples},
           {"--w-offset", "W", "weight of the offset from the line (greedy)",
            &settings.offset_weight},
           {"--w-delta", "W", "weight of tangents (greedy)", &settings.tangent_weight},
           {"--w-coarse", "W", "weight of the level above (greedy)", &settings.coarse_weight},
           {"--kappa", "K", "what it costs to leave a copied piece (greedy)", &settings.coherence},
           {"--epsilon", "E", "how much worse than the best may be chosen (greedy)",
            &settings.epsilon},
           {"--delta-t", "N", "spacings in a step of the first pass (greedy)", &settings.step},
           threads_option(settings.threads),
           {"--output,-o", "FILE", "write here rather than to stdout", &settings.output,
            HistoryUse::kLeftOut}},
      .inputs = &settings.inputs,
      .run = [&settings](Session& session) {
        settings.synthesize ? synthesize(settings, session) : draw(settings, session);
      }};
}

}  // namespace
}  // namespace libstyle

int main(int argc, char** argv) {
  libstyle::Settings settings;
  return libstyle::run_command(argc, argv, libstyle::describe(settings));
}
