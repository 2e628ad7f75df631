// SPDX-License-Identifier: Apache-2.0
#include "converters/common/json_object.h"

#include <cmath>

#include "libstyle/base/error.h"
#include "libstyle/base/number.h"
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

}  // namespace

void append_any_text(std::string& json, std::string_view text) {
  const std::size_t start = json.size();
  try {
    append_json_string(json, text);
  } catch (const Error&) {
    json.resize(start);
    append_json_string(json, without_foreign_bytes(text));
  }
}

std::string& JsonObject::begin(std::string_view key) {
  if (!members_.empty()) members_ += ',';
  append_json_string(members_, key);
  return members_ += ':';
}

JsonObject& JsonObject::text(std::string_view key, std::string_view value) {
  append_any_text(begin(key), value);
  return *this;
}

JsonObject& JsonObject::text_or_null(std::string_view key, std::string_view value) {
  if (!value.empty()) return text(key, value);
  begin(key) += "null";
  return *this;
}

JsonObject& JsonObject::flag(std::string_view key, bool value) {
  begin(key) += value ? "true" : "false";
  return *this;
}

JsonObject& JsonObject::count(std::string_view key, std::uint64_t value) {
  begin(key) += std::to_string(value);
  return *this;
}

JsonObject& JsonObject::line(std::string_view key, std::size_t value) {
  begin(key) += value == 0 ? "null" : std::to_string(value);
  return *this;
}

JsonObject& JsonObject::number(std::string_view key, std::optional<double> value) {
  std::string& json = begin(key);
  if (value && std::isfinite(*value)) {
    append_number(json, *value);
  } else {
    json += "null";
  }
  return *this;
}

JsonObject& JsonObject::object(std::string_view key, const JsonObject& value) {
  begin(key) += value.to_json();
  return *this;
}

JsonObject& JsonObject::list(std::string_view key, std::span<const JsonObject> values) {
  std::string& json = begin(key) += '[';
  for (std::size_t i = 0; i < values.size(); ++i) json += (i > 0 ? "," : "") + values[i].to_json();
  json += ']';
  return *this;
}

}  // namespace libstyle
