// SPDX-License-Identifier: Apache-2.0
#include "converters/common/report.h"

#include <algorithm>

namespace libstyle {
namespace {

void append_item(std::string& items, const JsonObject& item) {
  items += items.empty() ? "\n" : ",\n";
  items += item.to_json();
}

}  // namespace

Report::List& Report::list(std::string_view name) {
  const auto found = std::ranges::find(lists_, name, &List::name);
  if (found != lists_.end()) return *found;
  return lists_.emplace_back(List{std::string(name), {}});
}

void Report::add_to_list(std::string_view name, const JsonObject& item) {
  append_item(list(name).items, item);
}

void Report::add(Severity severity, const Place& place, std::string_view id,
                 std::string_view message) {
  const bool is_error = severity == Severity::kError;
  ++(is_error ? errors_ : warnings_);
  append_item(messages_.items, JsonObject()
                                   .text("severity", is_error ? "error" : "warning")
                                   .text_or_null("file", place.file)
                                   .line("line", place.line)
                                   .text_or_null("id", id)
                                   .text("message", message));
}

std::string Report::to_json(std::string_view program, int exit_code) const {
  std::string json = R"({"report":1,"program":)";
  append_any_text(json, program);
  json += R"(,"exit":)" + std::to_string(exit_code);
  json += R"(,"errors":)" + std::to_string(errors_);
  json += R"(,"warnings":)" + std::to_string(warnings_);
  const auto append_list = [&](const List& list) {
    json += ",\"" + list.name + "\":[" + list.items + "\n]";
  };
  append_list(messages_);
  for (const List& list : lists_) append_list(list);
  return json + "}\n";
}

}  // namespace libstyle
