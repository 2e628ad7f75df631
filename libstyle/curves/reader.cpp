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
    throw Error({name, base->line}, R"("id": ")" + base->id + "\" is also the id of line " +
                                        std::to_string(first->second) +
                                        "; ids are unique in a document");
  }
}

void to_object(json::ondemand::document& document, Object& object) {
  const simdjson::error_code code = document.get_object().get(object);
  if (code == simdjson::INCORRECT_TYPE) throw Error("not a JSON object");
  json::check(code);
}

void rewind(Object& object) { json::check(object.reset().error()); }

// Whether an object without "type" is a header, however it spells "curves".
bool has_curves(Object& object) {
  rewind(object);
  for (auto field : object) {
    std::string_view key;
    json::check(field.unescaped_key().get(key));
    if (key == "curves") return true;
  }
  return false;
}

// The type of a record; none for a header.
std::optional<std::string_view> find_type(Object& object) {
  json::Value value;
  const simdjson::error_code code = object.find_field_unordered("type").get(value);
  if (code == simdjson::NO_SUCH_FIELD) {
    if (has_curves(object)) return std::nullopt;
    throw Error(R"("type" is missing, or "curves" if it is a header)");
  }
  json::check(code);
  json::ondemand::json_type type{};
  json::check(value.type().get(type));
  if (type != json::ondemand::json_type::string) throw Error("\"type\" must be a string");
  return json::read_text(value);
}

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
    if (!find_header()) return false;
    is_broken_ = true;  // until it has been read whole
    is_at_header_ = false;
    in_line([&] { read_header(document.header); });
    while (next_line() && in_line([&] { return read_record(document.records); })) {
    }
    check_unique_ids(document, name_);
    is_broken_ = false;
    return true;
  }

 private:
  struct ParsedLine {
    json::ondemand::document document;
    Object object;
  };

  // Goes on to the next header. Anything else is an error before the first document, and passed
  // over after a broken one.
  bool find_header() {
    while (!is_at_header_) {
      if (!next_line()) return false;
      try {
        in_line([&] { require_header(); });
        is_at_header_ = true;
      } catch (const Error&) {
        if (!std::exchange(is_broken_, true)) throw;
      }
    }
    return true;
  }

  // Takes the next line that is not blank. One that cannot be had is the last.
  bool next_line() {
    if (has_ended_) return false;
    has_ended_ = true;
    try {
      do {
        if (!lines_.next(line_)) return false;
      } while (is_blank(line_.text));
    } catch (const Error& error) {
      throw Error({name_, lines_.line_number()}, error.what());
    }
    has_ended_ = false;
    return true;
  }

  // Does something with line_, and says of an Error in it where that was.
  template <typename Work>
  auto in_line(Work work) -> decltype(work()) {
    try {
      return work();
    } catch (const Error& error) {
      const bool cut = !line_.ended && !line_.text.ends_with('}');
      throw Error(
          {name_, line_.number},
          error.what() + std::string(cut ? "; the stream ends in the middle of this line" : ""));
    }
  }

  void parse(ParsedLine& parsed) {
    const std::string_view text = line_.text;
    json::check(parser_.iterate(text.data(), text.size(), text.size() + LineReader::kPadding)
                    .get(parsed.document));
    to_object(parsed.document, parsed.object);
  }

  // A header as programs write it: known even when what follows is broken, so that the document
  // before it is whole.
  bool is_plain_header() const { return line_.text.starts_with("{\"curves\":"); }

  void require_header() {
    if (is_plain_header()) return;
    ParsedLine parsed;
    parse(parsed);
    if (find_type(parsed.object)) {
      throw Error("a record before any header; a document begins with {\"curves\":1}");
    }
  }

  void read_header(Header& header) {
    ParsedLine parsed;
    parse(parsed);
    header.line = line_.number;
    object_reader_.read_object(parsed.object, header);
    require_end(parsed.document);
  }

  // Reads line_ onto `records`. False when it is the next header.
  bool read_record(Records& records) {
    is_at_header_ = is_plain_header();
    if (is_at_header_) return false;
    ParsedLine parsed;
    parse(parsed);
    const std::optional<std::string_view> type = find_type(parsed.object);
    is_at_header_ = !type;
    if (is_at_header_) return false;
    check_room(records);
    const auto known = std::ranges::find(kKnownTypes, *type, &KnownType::name);
    if (known == kKnownTypes.end()) {
      records.emplace_back(to_unknown(line_));
      return true;
    }
    rewind(parsed.object);
    known->read(object_reader_, parsed.object, line_.number, records);
    require_end(parsed.document);
    return true;
  }

  void check_room(const Records& records) const {
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
  Line line_;                  // the one read last
  bool has_ended_ = false;     // there are no more lines to be had
  bool is_at_header_ = false;  // line_ is a header that has not been read
  bool is_broken_ = false;     // what stands before the next header is not worth a word
  json::ondemand::parser parser_;
  ObjectReader object_reader_;
};

Reader::Reader(ByteSource& source, std::string name, const ReaderLimits& limits)
    : implementation_(std::make_unique<Implementation>(source, std::move(name), limits)) {}

Reader::~Reader() = default;

bool Reader::read(Document& document) { return implementation_->read(document); }

}  // namespace libstyle
