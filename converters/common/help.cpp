// SPDX-License-Identifier: Apache-2.0
#include "converters/common/help.h"

#include <algorithm>
#include <type_traits>

#include "libstyle/base/number.h"

namespace libstyle {
namespace {

constexpr std::size_t kTextColumn = 30;
constexpr std::size_t kLineWidth = 80;

// "-o, --output FILE", long names without a short one indented to line up.
std::string spelling(const Option& option) {
  const std::size_t comma = option.names.find(',');
  const std::string long_name = option.names.substr(0, comma);
  const std::string short_name =
      comma == std::string::npos ? "    " : option.names.substr(comma + 1) + ", ";
  const std::string value = option.value_name.empty() ? "" : " " + option.value_name;
  return "  " + short_name + long_name + value;
}

// The default as shown to people; empty when there is none worth showing.
std::string default_text(const Option& option) {
  return std::visit(
      [](const auto* target) -> std::string {
        using Value = std::remove_cvref_t<decltype(*target)>;
        std::string text;
        if constexpr (std::is_same_v<Value, std::string>) {
          text = *target;
        } else if constexpr (std::is_same_v<Value, bool>) {
          // A flag that is not given is off.
        } else if constexpr (std::is_arithmetic_v<Value>) {
          append_number(text, static_cast<double>(*target));
        } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
          if (*target) append_number(text, **target);
        }
        return text;
      },
      option.target);
}

std::string join(const std::vector<std::string>& words, std::string_view separator) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

std::string description(const Option& option) {
  std::string text = option.help;
  if (!option.choices.empty()) text += ": " + join(option.choices, ", ");
  if (const std::string value = default_text(option); !value.empty()) text += " [" + value + "]";
  return text;
}

// Appends `text` from column `column` on, broken at spaces, with a hanging indent.
void append_wrapped(std::string& out, std::string_view text, std::size_t column) {
  const std::size_t width = kLineWidth - column;
  while (text.size() > width) {
    std::size_t end = text.rfind(' ', width);
    if (end == std::string_view::npos || end == 0) end = width;
    out += text.substr(0, end);
    out += '\n' + std::string(column, ' ');
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  out += text;
  out += '\n';
}

void append_option(std::string& out, const Option& option) {
  std::string head = spelling(option);
  if (head.size() + 2 > kTextColumn) {
    out += head + '\n';
    head.clear();
  }
  head.resize(kTextColumn, ' ');
  out += head;
  append_wrapped(out, description(option), kTextColumn);
}

}  // namespace

std::string help_text(const Command& command, const std::vector<Option>& options) {
  std::string out = "Usage:\n";
  for (const std::string& line : command.synopsis) out += "  " + line + '\n';
  out += '\n';
  append_wrapped(out, command.name + " - " + command.summary + ".", 0);
  out += "\nOptions:\n";
  for (const Option& option : options) append_option(out, option);
  out += "\nThe manual: man " + command.name + "\n";
  return out;
}

}  // namespace libstyle
