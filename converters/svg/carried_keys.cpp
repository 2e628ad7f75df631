// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/carried_keys.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "converters/svg/scanner.h"
#include "libstyle/base/error.h"
#include "libstyle/curves/json_text.h"
#include "libstyle/curves/reader.h"
#include "libstyle/curves/writer.h"
#include "libstyle/geometry/path_data.h"

namespace libstyle::svg {
namespace {

bool is_name_character(char c) {
  const char lower = to_lower(c);
  return (lower >= 'a' && lower <= 'z') || is_digit(c) || c == '-' || c == '_' || c == '.' ||
         static_cast<unsigned char>(c) >= 0x80;
}

// What every record of its type has, when it says nothing.
constexpr std::string_view kEmptyPath = R"(,"d":"")";
constexpr std::string_view kEmptyGradient = R"(,"linear":{"x1":0,"y1":0,"x2":0,"y2":0},"stops":[])";
constexpr std::string_view kEmptyClip = R"(,"parts":[])";

// The keys of a record that have no attribute of their own.
std::vector<Extra> carried_extras(const RecordBase& record) {
  std::vector<Extra> extras;
  std::ranges::copy_if(record.extras, std::back_inserter(extras), std::not_fn(is_data_attribute));
  return extras;
}

// The line of a record that holds only what is to be carried. Its end and `required`, an empty
// value of a key that each record of its type has, are taken off.
std::string carried_line(const Record& rest, std::string_view required) {
  std::string line;
  append_record(line, rest);
  line.pop_back();
  // Quotes within texts are escaped, so this can only be the key itself.
  const std::size_t at = line.find(required);
  if (at != std::string::npos) line.erase(at, required.size());
  return line;
}

template <typename T>
std::string carried_extras_line(const T& record, std::string_view required) {
  T rest;
  rest.extras = carried_extras(record);
  return rest.extras.empty() ? "" : carried_line(rest, required);
}

// Reads one document; nothing when there is none or it is wrong.
std::optional<Document> read_document(std::string_view text) {
  TextSource source(text);
  Document document;
  try {
    if (!Reader(source, "").read(document)) return std::nullopt;
  } catch (const Error&) {
    return std::nullopt;
  }
  return document;
}

// The record in a line that carried keys are completed to by `required`: a key with its value.
std::optional<Record> read_carried(std::string_view carried, std::string_view required) {
  carried = trimmed(carried);
  if (!carried.ends_with('}')) return std::nullopt;
  carried.remove_suffix(1);
  std::string text = "{\"curves\":1}\n";
  text += carried;
  text += required;
  text += "}\n";
  std::optional<Document> document = read_document(text);
  if (!document || document->records.size() != 1) return std::nullopt;
  return std::move(document->records.front());
}

void append_extras(RecordBase& record, const RecordBase& carried) {
  record.extras.insert(record.extras.end(), carried.extras.begin(), carried.extras.end());
}

// The record around an object whose unknown keys are in `carried`: "{...}". The object begins and
// ends with what the texts give.
template <typename T>
std::optional<T> read_around(std::string_view before, std::string_view carried,
                             std::string_view after) {
  carried = trimmed(carried);
  if (!carried.starts_with('{') || !carried.ends_with('}')) return std::nullopt;
  std::string text = "{\"curves\":1}\n";
  text += before;
  text += ',';
  text += carried.substr(1, carried.size() - 2);
  text += after;
  std::optional<Document> document = read_document(text);
  if (!document || document->records.size() != 1) return std::nullopt;
  auto* record = std::get_if<T>(&document->records.front());
  return record ? std::optional(std::move(*record)) : std::nullopt;
}

template <typename Geometry>
bool restore_geometry_extras(std::string_view before, std::string_view carried,
                             Geometry& geometry) {
  auto around = read_around<GradientRecord>(before, carried, "},\"stops\":[]}\n");
  auto* read = around ? std::get_if<Geometry>(&around->geometry) : nullptr;
  if (read) geometry.extras = std::move(read->extras);
  return read != nullptr;
}

template <typename T>
bool restore_extras(std::string_view carried, std::string_view required, T& record) {
  const std::optional<Record> read = read_carried(carried, required);
  const T* rest = read ? std::get_if<T>(&*read) : nullptr;
  if (rest) append_extras(record, *rest);
  return rest != nullptr;
}

}  // namespace

std::string_view carried_id(std::string_view record_id, std::string_view xml_id) {
  const bool is_nameless = given_id(record_id).empty() && xml_id.empty();
  return record_id == xml_id || is_nameless ? std::string_view() : record_id;
}

// RecordIds makes "chair-2" of "chair~2", and "clip-1" of "~2".
bool fits_carried_id(std::string_view carried, std::string_view xml_id) {
  std::string_view rest = xml_id;
  const std::string_view given = given_id(carried);
  if (!given.empty()) {
    if (!rest.starts_with(given)) return rest.empty();
    rest.remove_prefix(given.size());
    if (rest.empty()) return true;
  } else {
    rest.remove_prefix(std::min(rest.find('-'), rest.size()));
  }
  return rest.size() > 1 && rest.front() == '-' && std::ranges::all_of(rest.substr(1), is_digit);
}

bool is_data_attribute(const Extra& extra) {
  constexpr std::string_view kPrefix = "data-";
  const std::string_view key = extra.key;
  return key.starts_with(kPrefix) && key.size() > kPrefix.size() &&
         std::ranges::all_of(key, is_name_character) && extra.json.starts_with('"');
}

std::string carried_keys(const PathRecord& path, bool keep_shape) {
  PathRecord rest;
  if (keep_shape) rest.shape = path.shape;
  rest.along = path.along;
  rest.extras = carried_extras(path);
  if (rest == PathRecord{}) return "";
  return carried_line(rest, kEmptyPath);
}

std::string carried_keys(const GroupRecord& group) { return carried_extras_line(group, ""); }

std::string carried_keys(const ElementRecord& element) {
  ElementRecord rest;
  rest.category = element.category;
  rest.position = element.position;
  rest.extras = carried_extras(element);
  return carried_line(rest, "");
}

std::string carried_keys(const GradientRecord& gradient) {
  return carried_extras_line(gradient, kEmptyGradient);
}

std::string carried_keys(const ClipRecord& clip) { return carried_extras_line(clip, kEmptyClip); }

bool restore_carried_keys(std::string_view carried, PathRecord& path) {
  std::optional<Record> record = read_carried(carried, R"(,"d":")" + to_path_data(path.path) + '"');
  auto* rest = record ? std::get_if<PathRecord>(&*record) : nullptr;
  if (!rest) return false;
  if (!rest->shape.empty()) path.shape = std::move(rest->shape);
  path.along = std::move(rest->along);
  append_extras(path, *rest);
  return true;
}

std::optional<Record> restore_carried_keys(std::string_view carried, const GroupRecord& group) {
  std::optional<Record> record = read_carried(carried, "");
  if (!record) return std::nullopt;
  if (auto* element = std::get_if<ElementRecord>(&*record)) {
    const std::vector<Extra> extras = std::move(element->extras);
    static_cast<RecordBase&>(*element) = group;
    element->extras.insert(element->extras.end(), extras.begin(), extras.end());
    return record;
  }
  const auto* rest = std::get_if<GroupRecord>(&*record);
  if (!rest) return std::nullopt;
  GroupRecord whole = group;
  append_extras(whole, *rest);
  return whole;
}

bool restore_carried_keys(std::string_view carried, GradientRecord& gradient) {
  return restore_extras(carried, kEmptyGradient, gradient);
}

bool restore_carried_keys(std::string_view carried, ClipRecord& clip) {
  return restore_extras(carried, kEmptyClip, clip);
}

std::string carried_extras(const std::vector<Extra>& extras) {
  std::string text;
  for (const Extra& extra : extras) {
    text += text.empty() ? '{' : ',';
    append_json_string(text, extra.key);
    text += ':';
    text += extra.json;
  }
  if (!text.empty()) text += '}';
  return text;
}

bool restore_carried_extras(std::string_view carried, GradientStop& stop) {
  auto around =
      read_around<GradientRecord>(R"({"type":"gradient","linear":{"x1":0,"y1":0,"x2":0,"y2":0},)"
                                  R"("stops":[{"offset":0,"stop-color":"#000000")",
                                  carried, "}]}\n");
  if (!around || around->stops.size() != 1) return false;
  stop.extras = std::move(around->stops.front().extras);
  return true;
}

bool restore_carried_extras(std::string_view carried, LinearGeometry& linear) {
  return restore_geometry_extras(R"({"type":"gradient","linear":{"x1":0,"y1":0,"x2":0,"y2":0)",
                                 carried, linear);
}

bool restore_carried_extras(std::string_view carried, RadialGeometry& radial) {
  return restore_geometry_extras(R"({"type":"gradient","radial":{"cx":0,"cy":0,"r":0)", carried,
                                 radial);
}

bool restore_carried_extras(std::string_view carried, ClipPart& part) {
  auto around = read_around<ClipRecord>(R"({"type":"clip","parts":[{"d":"")", carried, "}]}\n");
  if (!around || around->parts.size() != 1) return false;
  part.extras = std::move(around->parts.front().extras);
  return true;
}

std::optional<Document> restore_carried_records(std::string_view carried) {
  std::string text;
  while (!carried.empty()) {  // lines are indented
    const std::size_t end = std::min(carried.find('\n'), carried.size());
    text += trimmed(carried.substr(0, end));
    text += '\n';
    carried.remove_prefix(std::min(end + 1, carried.size()));
  }
  return read_document(text);
}

}  // namespace libstyle::svg
