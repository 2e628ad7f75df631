// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/style_option.h"

#include <optional>

#include "converters/common/command.h"
#include "libstyle/base/error.h"
#include "libstyle/base/number.h"

namespace libstyle {
namespace {

bool is_scale(std::string_view text) {
  double factor = 0;
  return text == "auto" || (take_number(text, factor) && text.empty());
}

// UNFILTERED:FILTERED@SCALE; nothing if a name is missing or there are too many.
std::optional<ExampleFiles> parse_files(std::string_view text) {
  ExampleFiles files;
  const std::size_t at = text.rfind('@');
  if (at != std::string_view::npos && is_scale(text.substr(at + 1))) {
    files.scale = text.substr(at + 1);
    text = text.substr(0, at);
  }
  const std::size_t colon = text.find(':');
  if (colon != std::string_view::npos) {
    files.unfiltered = text.substr(0, colon);
    if (files.unfiltered.empty()) return std::nullopt;
    text.remove_prefix(colon + 1);
  }
  files.filtered = text;
  const bool is_one_name = !text.empty() && text.find(':') == std::string_view::npos;
  return is_one_name ? std::optional(files) : std::nullopt;
}

}  // namespace

StyleOption parse_style_option(std::string_view text) {
  const auto wrong = [&](const std::string& what) {
    return UsageError("--style " + std::string(text) + ": " + what);
  };
  const std::size_t equals = text.find('=');
  std::optional<ExampleFiles> files;
  if (equals != std::string_view::npos) files = parse_files(text.substr(equals + 1));
  if (!files) throw wrong("give WHAT=UNFILTERED.svg:FILTERED.svg or WHAT=FILTERED.svg");
  const std::string_view what = text.substr(0, equals);
  try {
    return {std::string(what), RecordSelector(what, BareWord::kAnything), *files};
  } catch (const Error& error) {
    throw wrong(error.what());
  }
}

}  // namespace libstyle
