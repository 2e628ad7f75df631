// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/style_file.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "cli/curve_analogy/examples.h"
#include "cli/curve_analogy/explain.h"
#include "converters/common/command.h"
#include "converters/common/files.h"
#include "libstyle/analogy/curve_analogy.h"
#include "libstyle/analogy/style_document.h"
#include "libstyle/base/error.h"
#include "libstyle/base/number.h"
#include "libstyle/curves/json_text.h"
#include "libstyle/curves/writer.h"

namespace libstyle {
namespace {

// ---- Values of options as JSON ------------------------------------------------------------------

std::string json_of(double value) {
  std::string json;
  append_number(json, value);
  return json;
}

// A number where the text is one. Empty where it is empty.
std::string json_of(const std::string& text) {
  std::string_view rest = text;
  double number = 0;
  if (take_number(rest, number) && rest.empty()) return json_of(number);
  std::string json;
  if (!text.empty()) append_json_string(json, text);
  return json;
}

// Empty where the option says nothing.
std::string value_of(const Option& option) {
  return std::visit(
      [](const auto* value) -> std::string {
        using Value = std::remove_cvref_t<decltype(*value)>;
        if constexpr (std::is_same_v<Value, bool>) {
          return *value ? "true" : "";
        } else if constexpr (std::is_same_v<Value, std::string>) {
          return json_of(*value);
        } else if constexpr (std::is_integral_v<Value>) {
          return std::to_string(*value);
        } else if constexpr (std::is_same_v<Value, double>) {
          return json_of(*value);
        } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
          return *value ? json_of(**value) : "";
        } else {
          return "";  // no style has a list
        }
      },
      option.target);
}

Error wrong_value(const Option& option, const std::string& wanted) {
  return Error('"' + long_name(option) + "\" must be " + wanted);
}

std::string text_of(const Option& option, std::string_view json) {
  const bool is_free = option.choices.empty();
  std::string_view rest = json;
  double number = 0;
  if (is_free && take_number(rest, number) && rest.empty()) return std::string(json);
  const std::optional<std::string> text = parse_json_string(json);
  if (text && (is_free || std::ranges::count(option.choices, *text) > 0)) return *text;
  std::string wanted = is_free ? "a number or a text" : "";
  for (const std::string& choice : option.choices) {
    wanted += (wanted.empty() ? "\"" : " or \"") + choice + '"';
  }
  throw wrong_value(option, wanted);
}

double number_of(const Option& option, std::string_view json) {
  double value = 0;
  if (!take_number(json, value) || !json.empty()) throw wrong_value(option, "a number");
  return value;
}

template <typename Whole>
Whole whole_number_of(const Option& option, std::string_view json) {
  Whole value = 0;
  const auto [end, code] = std::from_chars(json.data(), json.data() + json.size(), value);
  if (code != std::errc() || end != json.data() + json.size() || json.starts_with('-')) {
    throw wrong_value(option, "a whole number, 0 or more");
  }
  return value;
}

void set_value(const Option& option, std::string_view json) {
  std::visit(
      [&](auto* target) {
        using Value = std::remove_cvref_t<decltype(*target)>;
        if constexpr (std::is_same_v<Value, bool>) {
          if (json != "true" && json != "false") throw wrong_value(option, "true or false");
          *target = json == "true";
        } else if constexpr (std::is_same_v<Value, std::string>) {
          *target = text_of(option, json);
        } else if constexpr (std::is_integral_v<Value>) {
          *target = whole_number_of<Value>(option, json);
        } else if constexpr (!std::is_same_v<Value, std::vector<std::string>>) {
          *target = number_of(option, json);
        }
      },
      option.target);
}

// ---- The file -----------------------------------------------------------------------------------

void refuse_other_work(const Settings& settings) {
  const auto refuse = [](bool given, const char* option) {
    if (given) throw UsageError(std::string("--save-style does not go with ") + option);
  };
  refuse(!settings.styles.empty(), "--style; give the example as --filtered FILE");
  refuse(!settings.through.empty(), "--through");
  refuse(settings.synthesize.has_value(), "--synthesize; the style serves for both");
  for (const char* option : {"--variants", "--frames", "--coherence"}) {
    refuse(settings.is_given(option), option);
  }
  refuse(settings.inputs != std::vector<std::string>{"-"}, "an input; it draws nothing");
}

}  // namespace

void save_style(const Settings& settings, Session& session) {
  refuse_other_work(settings);
  StyleSource source = read_style_source(settings, session);
  refuse_idle_symbols(settings, source.settings.is_greedy());
  const CurveAnalogyParameters parameters = source.parameters();
  const StyleSummary summary =
      at_place({source.file}, [&] { return CurveAnalogy(source.pairs, parameters).summary(); });
  if (settings.explain) session.message(explanation(source.file, summary, {}));

  Document style = style_document(source.pairs, source.filtered);
  style.header.history = {session.history()};
  for (const Option& option : style_options(source.settings)) {
    const std::string value = value_of(option);
    if (!value.empty()) style.header.extras.push_back({long_name(option), value});
  }
  style.header.extras.push_back(
      {"feature-size-found", json_of(summary.feature_size / parameters.scale)});
  OutputFile output(settings.save_style);
  write_document(output, style);
  output.commit();
}

Settings with_kept_options(const Settings& settings, const Document& style,
                           const std::string& file) {
  Settings result = settings;
  const std::vector<Option> options = style_options(result);
  for (const Extra& extra : style.header.extras) {
    if (!extra.key.starts_with("--")) continue;
    const auto option = std::ranges::find(options, extra.key, long_name);
    at_place({file, style.header.line}, [&] {
      if (option == options.end()) {
        throw Error('"' + extra.key + "\" is no option that a style has");
      }
      // The method that is given wins over a kept --faithful.
      const bool is_given = settings.is_given(extra.key) ||
                            (extra.key == "--faithful" && settings.is_given("--method"));
      if (!is_given) set_value(*option, extra.json);
    });
  }
  return result;
}

}  // namespace libstyle
