// SPDX-License-Identifier: Apache-2.0
#include "converters/common/report.h"

#include "libstyle/curves/json_text.h"

namespace libstyle {
namespace {

// Every byte beyond ASCII replaced by U+FFFD.
std::string without_foreign_bytes(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x80) {
      plain += c;
    } else {
      plain += "\xef\xbf\xbd";
    }
  }
  return plain;
}

// Names of files can be any bytes, but JSON is UTF-8.
void append_text(std::string& json, std::string_view text) {
  const std::size_t start = json.size();
  try {
    append_json_string(json, text);
  } catch (const Error&) {
    json.resize(start);
    append_json_string(json, without_foreign_bytes(text));
  }
}

void append_text_or_null(std::string& json, std::string_view text) {
  if (text.empty()) {
    json += "null";
  } else {
    append_text(json, text);
  }
}

}  // namespace

void Report::add(Severity severity, const Place& place, std::string_view id,
                 std::string_view message) {
  ++(severity == Severity::kError ? errors_ : warnings_);
  messages_ += messages_.empty() ? "\n" : ",\n";
  messages_ += severity == Severity::kError ? R"({"severity":"error","file":)"
                                            : R"({"severity":"warning","file":)";
  append_text_or_null(messages_, place.file);
  messages_ += R"(,"line":)" + (place.line == 0 ? "null" : std::to_string(place.line));
  messages_ += R"(,"id":)";
  append_text_or_null(messages_, id);
  messages_ += R"(,"message":)";
  append_text(messages_, message);
  messages_ += '}';
}

std::string Report::to_json(std::string_view program, int exit_code) const {
  std::string json = R"({"report":1,"program":)";
  append_text(json, program);
  json += R"(,"exit":)" + std::to_string(exit_code);
  json += R"(,"errors":)" + std::to_string(errors_);
  json += R"(,"warnings":)" + std::to_string(warnings_);
  json += R"(,"messages":[)" + messages_ + "\n]}\n";
  return json;
}

}  // namespace libstyle
