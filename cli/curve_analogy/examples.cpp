// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/examples.h"

#include <utility>

#include "cli/curve_analogy/style_file.h"
#include "cli/curve_analogy/style_option.h"
#include "converters/common/command.h"
#include "converters/common/files.h"
#include "converters/svg/document_input.h"
#include "libstyle/analogy/example_document.h"
#include "libstyle/analogy/style_document.h"
#include "libstyle/base/error.h"

namespace libstyle {
namespace {

// The first document of a file.
Document read_example(const std::string& name, Session& session) {
  DocumentInput input(name, session.warning_handler());
  Document document;
  if (!input.read(document)) throw Error({display_name(name)}, "the example is empty");
  return document;
}

// Adds the name of the file to the place of an error.
template <typename Work>
auto in_file(const std::string& file, Work work) {
  try {
    return work();
  } catch (const Error& error) {
    throw Error({file, error.place().line}, error.message());
  }
}

StyleSource source_from_style(Document style, const Settings& settings, const std::string& file) {
  StyleSource source{file, std::move(style), {}, settings, true};
  source.pairs = in_file(file, [&] { return style_pairs(source.filtered); });
  source.settings = with_kept_options(settings, source.filtered, file);
  return source;
}

StyleSource source_from_example(Document filtered, const std::string& unfiltered_name,
                                const Settings& settings, const std::string& file,
                                Session& session) {
  StyleSource source{file, std::move(filtered), {}, settings, false};
  std::optional<Document> unfiltered;
  if (!unfiltered_name.empty()) unfiltered = read_example(unfiltered_name, session);
  source.pairs = at_place(
      {file}, [&] { return example_pairs(unfiltered ? &*unfiltered : nullptr, source.filtered); });
  return source;
}

// The style of --style, from a style file or not.
StyleSource read_part_source(const ExampleFiles& files, const Settings& settings,
                             Session& session) {
  const std::string file = display_name(files.filtered);
  Document document = read_example(files.filtered, session);
  const bool is_style = is_style_document(document);
  if (is_style && !files.unfiltered.empty()) {
    throw Error({file}, "is a style, which has its unfiltered curves in it; leave out " +
                            display_name(files.unfiltered));
  }
  StyleSource source = is_style ? source_from_style(std::move(document), settings, file)
                                : source_from_example(std::move(document), files.unfiltered,
                                                      settings, file, session);
  if (!files.scale.empty()) source.settings.scale = files.scale;
  return source;
}

}  // namespace

CurveAnalogyParameters StyleSource::parameters() const {
  try {
    return checked_parameters(settings, scale());
  } catch (const UsageError& error) {
    if (!is_style_file) throw;
    throw Error({file, filtered.header.line}, error.what());
  }
}

StyleSource read_style_source(const Settings& settings, Session& session) {
  if (settings.style_file.empty()) {
    if (settings.filtered.empty()) {
      throw UsageError("give an example of the style: --filtered FILE");
    }
    const std::string file = display_name(settings.filtered);
    Document filtered = read_example(settings.filtered, session);
    if (is_style_document(filtered)) {
      throw Error({file}, "is a style; give it as --style-file FILE");
    }
    return source_from_example(std::move(filtered), settings.unfiltered, settings, file, session);
  }
  if (!settings.filtered.empty() || !settings.unfiltered.empty()) {
    throw UsageError("--style-file has its example in it; leave out --filtered and --unfiltered");
  }
  return source_from_style(read_example(settings.style_file, session), settings,
                           display_name(settings.style_file));
}

StyleSet read_styles(const Settings& settings, Session& session) {
  std::vector<StyleOption> options;
  for (const std::string& text : settings.styles) options.push_back(parse_style_option(text));
  const bool has_rest = !settings.filtered.empty() || !settings.style_file.empty();
  if (!has_rest && (options.empty() || !settings.unfiltered.empty())) {
    throw UsageError("give an example of the style: --filtered FILE, or --style WHAT=FILE");
  }
  checked_parameters(settings,
                     parse_scale(settings.scale));  // what the command line says by itself
  bool any_greedy = false;
  const auto to_style = [&](std::string name, StyleSource source) {
    const CurveAnalogyParameters parameters = source.parameters();
    any_greedy = any_greedy || source.settings.is_greedy();
    return StyleExample{std::move(name), std::move(source.pairs), parameters, !source.scale()};
  };
  std::optional<StyleExample> rest;
  if (has_rest) rest = to_style("the style", read_style_source(settings, session));
  StyleSet styles(std::move(rest));
  for (StyleOption& option : options) {
    styles.add(std::move(option.part), to_style("--style " + option.what,
                                                read_part_source(option.files, settings, session)));
  }
  refuse_idle_symbols(settings, any_greedy);
  return styles;
}

}  // namespace libstyle
