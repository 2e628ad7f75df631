// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/synthesize.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/curve_analogy/examples.h"
#include "converters/common/command.h"
#include "converters/common/files.h"
#include "libstyle/analogy/synthesis_document.h"
#include "libstyle/base/error.h"
#include "libstyle/curves/writer.h"

namespace libstyle {

void synthesize(const Settings& settings, Session& session) {
  const auto refuse = [](bool given, const char* option) {
    if (given) throw UsageError(std::string("--synthesize does not go with ") + option);
  };
  refuse(!settings.styles.empty(), "--style; give the example as --filtered FILE");
  refuse(!settings.unfiltered.empty(), "--unfiltered");
  refuse(settings.is_greedy(), "--method greedy and --faithful");
  refuse(settings.inputs != std::vector<std::string>{"-"}, "an input");
  const std::optional<double> scale = parse_scale(settings.scale);
  refuse(!scale, "--scale auto");
  if (settings.filtered.empty()) throw UsageError("give an example of the style: --filtered FILE");
  if (!(*settings.synthesize > 0)) throw UsageError("--synthesize must be above 0");

  refuse(settings.frames || settings.frame_coherence, "--frames");
  const int variants = settings.document_count();
  const CurveAnalogyParameters parameters = checked_parameters(settings, scale);
  const Document example = read_example(settings.filtered, session);
  OutputFile output(settings.output);
  at_place({display_name(settings.filtered)}, [&] {
    const CurveSynthesis style(synthesis_examples(example), parameters);
    for (int i = 0; i < variants; ++i) {
      Document document =
          synthesized_document(style, example, *settings.synthesize, static_cast<std::uint64_t>(i));
      document.header.history = {session.history()};
      if (settings.variants) document.header.name = variant_name(document.header.name, i + 1);
      write_document(output, document);
    }
  });
  output.commit();
}

}  // namespace libstyle
