// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/reader.h"

#include <unordered_map>
#include <utility>

#include "libstyle/curves/line_reader.h"
#include "libstyle/curves/object_reader.h"

namespace libstyle {
namespace {

static_assert(LineReader::kPadding >= simdjson::SIMDJSON_PADDING);

using Object = json::ondemand::object;
using fields::ObjectReader;

// A type of record by its name, and how one is read onto the end of a document.
struct KnownType {
  std::string_view name;
  void (*read)(ObjectReader& reader, Object& object, std::size_t line, Records& records);
};

constexpr std::size_t kKnownTypeCount = std::variant_size_v<Record> - 1;
static_assert(std::is_same_v<std::variant_alternative_t<kKnownTypeCount, Record>, UnknownRecord>);

constexpr auto kKnownTypes = []<std::size_t... I>(std::index_sequence<I...>) {
  return std::array<KnownType, sizeof...(I)>{
      KnownType{std::variant_alternative_t<I, Record>::kType,
                [](ObjectReader& reader, Object& object, std::size_t line, Records& records) {
                  auto& record = std::get<I>(records.emplace_back(std::in_place_index<I>));
                  record.line = line;
                  reader.read_object(object, record);
                }}...};
}
(std::make_index_sequence<kKnownTypeCount>());

// Throws at the first id that an earlier record has already. At the end of a document, when the
// table can be made at its full size.
void check_unique_ids(const Document& document, const std::string& name) {
  std::unordered_map<std::string_view, std::size_t> line_of_id;
  line_of_id.reserve(document.records.size());
  for (const Record& record : document.records) {
    const RecordBase* base = base_of(record);
    if (!base || base->id.empty()) continue;
    const auto [first, added] = line_of_id.emplace(base->id, base->line);
    if (added) continue;
    throw Error({name, base->line}, "\"id\": \"" + base->id + "\" is also the id of line " +
                                        std::to_string(first->second) +
                                        "; ids are unique in a document");
  }
}

void to_object(json::ondemand::document& document, Object& object) {
  const simdjson::error_code code = document.get_object().get(object);
  if (code == simdjson::INCORRECT_TYPE) throw Error("not a JSON object");
  json::check(code);
}

// The type of a record; none for a header.
std::optional<std::string_view> find_type(Object& object) {
  json::Value value;
  const simdjson::error_code code = object.find_field_unordered("type").get(value);
  if (code == simdjson::NO_SUCH_FIELD) return std::nullopt;
  json::check(code);
  json::ondemand::json_type type{};
  json::check(value.type().get(type));
  if (type != json::ondemand::json_type::string) throw Error("\"type\" must be a string");
  return json::read_text(value);
}

void rewind(Object& object) { json::check(object.reset().error()); }

void require_end(json::ondemand::document& document) {
  if (document.current_location().error() != simdjson::OUT_OF_BOUNDS) {
    throw Error("not JSON: something follows the object");
  }
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r") == std::string_view::npos;
}

}  // namespace

class Reader::Implementation {
 public:
  Implementation(ByteSource& source, std::string name, const ReaderLimits& limits)
      : lines_(source, limits.record_bytes), name_(std::move(name)), limits_(limits) {}

  bool read(Document& document) {
    document.header = {};
    document.records.clear();
    // Before the first document there can only be a header; parse_line sees to that.
    if (!next_header_ && !take_line(document.records)) return false;
    document.header = *std::exchange(next_header_, std::nullopt);
    in_document_ = true;
    while (!next_header_ && take_line(document.records)) {
    }
    check_unique_ids(document, name_);
    return true;
  }

 private:
  // Reads a line that is not blank into next_header_ or onto `records`. False at the end.
  bool take_line(Records& records) {
    Line line;
    try {
      do {
        if (!lines_.next(line)) return false;
      } while (is_blank(line.text));
      parse_line(line, records);
    } catch (const Error& error) {
      const bool cut = !line.ended && !line.text.ends_with('}');
      throw Error(
          {name_, lines_.line_number()},
          error.what() + std::string(cut ? "; the stream ends in the middle of this line" : ""));
    }
    return true;
  }

  void parse_line(const Line& line, Records& records) {
    json::ondemand::document document;
    json::check(
        parser_.iterate(line.text.data(), line.text.size(), line.text.size() + LineReader::kPadding)
            .get(document));
    Object object;
    to_object(document, object);
    const std::optional<std::string_view> type = find_type(object);
    if (!type) {
      rewind(object);
      next_header_.emplace().line = line.number;
      object_reader_.read_object(object, *next_header_);
    } else {
      check_room(records);
      const auto known = std::ranges::find(kKnownTypes, *type, &KnownType::name);
      if (known == kKnownTypes.end()) {
        records.emplace_back(to_unknown(line));
        return;
      }
      rewind(object);
      known->read(object_reader_, object, line.number, records);
    }
    require_end(document);
  }

  void check_room(const Records& records) const {
    if (!in_document_) {
      throw Error("a record before any header; a document begins with {\"curves\":1}");
    }
    if (records.size() >= limits_.records) {
      throw Error("the document has more than " + std::to_string(limits_.records) +
                  " records; divide it");
    }
  }

  UnknownRecord to_unknown(const Line& line) {
    const auto checked = object_reader_.raw_checker().check_text(line.text);
    if (checked.element.at_key("curves").error() == simdjson::SUCCESS) fields::fail_both_kinds();
    return {std::string(line.text), line.number};
  }

  LineReader lines_;
  std::string name_;
  ReaderLimits limits_;
  bool in_document_ = false;
  std::optional<Header> next_header_;
  json::ondemand::parser parser_;
  ObjectReader object_reader_;
};

Reader::Reader(ByteSource& source, std::string name, const ReaderLimits& limits)
    : implementation_(std::make_unique<Implementation>(source, std::move(name), limits)) {}

Reader::~Reader() = default;

bool Reader::read(Document& document) { return implementation_->read(document); }

}  // namespace libstyle
