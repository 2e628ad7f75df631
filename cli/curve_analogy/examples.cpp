// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/examples.h"

#include <optional>
#include <utility>
#include <vector>

#include "cli/curve_analogy/style_option.h"
#include "converters/common/command.h"
#include "converters/common/files.h"
#include "converters/svg/document_input.h"
#include "libstyle/analogy/example_document.h"
#include "libstyle/base/error.h"

namespace libstyle {
namespace {

std::vector<ExamplePair> read_pairs(const ExampleFiles& files, Session& session) {
  const Document filtered = read_example(files.filtered, session);
  std::optional<Document> unfiltered;
  if (!files.unfiltered.empty()) unfiltered = read_example(files.unfiltered, session);
  return at_place({display_name(files.filtered)},
                  [&] { return example_pairs(unfiltered ? &*unfiltered : nullptr, filtered); });
}

StyleExample read_style(std::string name, const ExampleFiles& files, const Settings& settings,
                        Session& session) {
  const std::optional<double> scale =
      parse_scale(files.scale.empty() ? settings.scale : files.scale);
  StyleExample style{std::move(name), {}, checked_parameters(settings, scale), !scale};
  style.pairs = read_pairs(files, session);
  return style;
}

}  // namespace

Document read_example(const std::string& name, Session& session) {
  DocumentInput input(name, session.warning_handler());
  Document document;
  if (!input.read(document)) throw Error({display_name(name)}, "the example is empty");
  return document;
}

StyleSet read_styles(const Settings& settings, Session& session) {
  std::vector<StyleOption> options;
  for (const std::string& text : settings.styles) options.push_back(parse_style_option(text));
  const bool has_rest = !settings.filtered.empty();
  if (!has_rest && (options.empty() || !settings.unfiltered.empty())) {
    throw UsageError("give an example of the style: --filtered FILE, or --style WHAT=FILE");
  }
  std::optional<StyleExample> rest;
  if (has_rest) {
    rest = read_style("the style", {settings.unfiltered, settings.filtered, {}}, settings, session);
  }
  StyleSet styles(std::move(rest));
  for (StyleOption& option : options) {
    styles.add(std::move(option.part),
               read_style("--style " + option.what, option.files, settings, session));
  }
  return styles;
}

}  // namespace libstyle
