// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/draw.h"

#include <cstdint>
#include <string>

#include "cli/curve_analogy/examples.h"
#include "converters/common/files.h"
#include "converters/svg/document_input.h"
#include "libstyle/analogy/drawing.h"
#include "libstyle/curves/writer.h"

namespace libstyle {
namespace {

// Warnings of the library know a line; the file is known here.
WarningHandler warnings_from(const std::string& input, Session& session) {
  return [&session, file = display_name(input)](const Warning& warning) {
    session.warn({{file, warning.place.line}, warning.id, warning.message});
  };
}

}  // namespace

void draw(const Settings& settings, Session& session) {
  const int count = settings.document_count();
  const double coherence = settings.coherence_of_frames();
  StyleSet styles = read_styles(settings, session);
  OutputFile output(settings.output);
  for (const std::string& name : settings.inputs) {
    DocumentInput input(name, session.warning_handler());
    Document document;
    while (input.read(document)) {
      DrawingOptions options{settings.threads, session.progress_handler(),
                             warnings_from(name, session)};
      const StylePlan plan = styles.plan(document, options.warn);
      DrawnWalks walks;
      options.coherence = coherence;
      if (settings.frames) options.walks = &walks;
      for (int i = 0; i < count; ++i) {
        Document variant = document;
        if (settings.is_numbered()) variant.header.name = variant_name(document.header.name, i + 1);
        variant.header.history.push_back(session.history());
        options.variant = static_cast<std::uint64_t>(i);
        draw_again(variant, plan, options);
        write_document(output, variant);
        options.warn = {};  // the first has said it
      }
    }
  }
  output.commit();
}

}  // namespace libstyle
