// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/entities.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string_view>

#include "converters/svg/encoding.h"

namespace libstyle::svg {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

struct Entity {
  std::string value;
  std::string quoted_value;  // the same where it stands within quotes, which it must not end
  bool external = false;
};

// What a reference counts for beside its text: empty entities take time too.
constexpr std::size_t kReferenceCost = 16;

using EntityMap = std::map<std::string, Entity, std::less<>>;

// Reads a declaration piece by piece.
class DeclarationReader {
 public:
  explicit DeclarationReader(std::string_view text) : rest_(text) {}

  bool at_end() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }
  void skip_space() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kSpace), rest_.size()));
  }
  void skip(std::size_t count) { rest_.remove_prefix(std::min(count, rest_.size())); }
  // Passes over everything up to and including `end`.
  void skip_past(std::string_view end) {
    const std::size_t at = rest_.find(end);
    skip(at == std::string_view::npos ? at : at + end.size());
  }
  bool take(std::string_view token) {
    if (!rest_.starts_with(token)) return false;
    skip(token.size());
    return true;
  }
  std::string_view take_name() {
    const std::string_view name = rest_.substr(0, rest_.find_first_of(" \t\r\n\"'<>[]%;&"));
    skip(name.size());
    return name;
  }
  // A quoted text without its quotes.
  bool take_quoted(std::string_view& value) {
    if (rest_.empty() || (rest_[0] != '"' && rest_[0] != '\'')) return false;
    const std::size_t end = rest_.find(rest_[0], 1);
    if (end == std::string_view::npos) return false;
    value = rest_.substr(1, end - 1);
    skip(end + 1);
    return true;
  }
  // Passes over a declaration up to its '>', quoted texts respected.
  void skip_declaration() {
    while (!at_end() && !take(">")) {
      std::string_view quoted;
      if (!take_quoted(quoted)) skip(1);
    }
  }

 private:
  std::string_view rest_;
};

// To a character; longer ones have zeros in front. Looking further would make a file of "&#" slow.
constexpr std::size_t kLongestReference = 32;

bool is_xml_character(std::uint32_t code) {
  return code > 0 && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
}

// Removes "&#38;" or "&#x26;" from the front of `text` and appends the character. Says no, leaving
// both alone, when there stands anything else.
bool take_character_reference(std::string_view& text, std::string& value) {
  const std::size_t end = text.substr(0, kLongestReference).find(';');
  if (!text.starts_with("&#") || end == std::string_view::npos) return false;
  std::string_view digits = text.substr(2, end - 2);
  const int base = digits.starts_with('x') ? 16 : 10;
  if (base == 16) digits.remove_prefix(1);
  std::uint32_t code = 0;
  const auto [rest, fault] =
      std::from_chars(digits.data(), digits.data() + digits.size(), code, base);
  const bool whole = fault == std::errc() && rest == digits.data() + digits.size();
  if (!whole || !is_xml_character(code)) return false;
  append_utf8(value, code);
  text.remove_prefix(end + 1);
  return true;
}

// What is put in place of a reference to an entity: references to characters in its value count
// where it is declared, those to entities where it stands (XML 1.0, sections 4.4 and 4.5).
std::string replacement_text(std::string_view value) {
  std::string text;
  while (!value.empty()) {
    if (take_character_reference(value, text)) continue;
    const std::size_t plain = std::min(value.find('&', 1), value.size());
    text += value.substr(0, plain);
    value.remove_prefix(plain);
  }
  return text;
}

Entity make_entity(std::string_view value) {
  Entity entity;
  for (const char c : replacement_text(value)) {
    const char plain = c == '\n' || c == '\r' ? ' ' : c;
    entity.value += plain;
    if (c == '"') {
      entity.quoted_value += "&quot;";
    } else if (c == '\'') {
      entity.quoted_value += "&apos;";
    } else {
      entity.quoted_value += plain;
    }
  }
  return entity;
}

// A file may declare what XML has already, only not as anything else (section 4.6).
bool is_predefined(std::string_view name) {
  constexpr std::string_view kNames[] = {"lt", "gt", "amp", "apos", "quot"};
  return std::ranges::find(kNames, name) != std::end(kNames);
}

// After "<!ENTITY". Parameter entities (%) serve only the declaration itself and are passed over.
void read_entity(DeclarationReader& reader, EntityMap& entities) {
  reader.skip_space();
  const std::string name(reader.take_name());
  reader.skip_space();
  std::string_view value;
  if (is_predefined(name)) return reader.skip_declaration();
  if (!name.empty() && reader.take_quoted(value)) {
    entities.try_emplace(name, make_entity(value));
  } else if (!name.empty()) {
    entities.try_emplace(name, Entity{"", "", true});
  }
  reader.skip_declaration();
}

// Reads the internal subset after '[', up to and including its ']'.
void read_internal_subset(DeclarationReader& reader, EntityMap& entities) {
  while (!reader.at_end() && !reader.take("]")) {
    if (reader.take("<!ENTITY")) {
      read_entity(reader, entities);
    } else if (reader.take("<!--")) {
      reader.skip_past("-->");
    } else if (reader.take("<?")) {
      reader.skip_past("?>");
    } else if (reader.take("<!")) {
      reader.skip_declaration();
    } else {
      reader.skip(1);
    }
  }
}

// Passes over what may stand before a document type declaration.
void skip_prolog(DeclarationReader& reader) {
  while (true) {
    reader.skip_space();
    if (reader.take("<!--")) {
      reader.skip_past("-->");
    } else if (reader.take("<?")) {
      reader.skip_past("?>");
    } else {
      return;
    }
  }
}

// Reads the entities of the document type declaration; returns its place in the text.
std::string_view read_doctype(std::string_view text, EntityMap& entities) {
  DeclarationReader reader(text);
  skip_prolog(reader);
  const std::string_view begin = reader.rest();
  if (!reader.take("<!DOCTYPE")) return {};
  while (!reader.at_end() && !reader.take(">")) {
    std::string_view quoted;
    if (reader.take("[")) {
      read_internal_subset(reader, entities);
    } else if (!reader.take_quoted(quoted)) {
      reader.skip(1);
    }
  }
  return begin.substr(0, begin.size() - reader.rest().size());
}

void blank(std::string& text, std::size_t begin, std::size_t count) {
  for (std::size_t i = begin; i < begin + count; ++i) {
    if (text[i] != '\n') text[i] = ' ';
  }
}

class Expander {
 public:
  Expander(const EntityMap& entities, const std::string& file, const EntityLimits& limits,
           const WarningHandler& warn)
      : entities_(entities), file_(file), limits_(limits), warn_(warn) {}

  std::string expand(std::string_view text) {
    result_.reserve(text.size());
    append_markup(text);
    return std::move(result_);
  }

 private:
  // Tags, comments, CDATA and the text between them.
  void append_markup(std::string_view text) {
    while (!text.empty()) {
      if (text.starts_with("<!--")) {
        append_verbatim(text, "-->");
      } else if (text.starts_with("<![CDATA[")) {
        append_verbatim(text, "]]>");
      } else if (text.starts_with("<?")) {
        append_verbatim(text, "?>");
      } else if (text[0] == '<') {
        append_tag(text);
      } else {
        const std::string_view run = text.substr(0, text.find('<'));
        append_references(run, false);
        text.remove_prefix(run.size());
      }
    }
  }

  void append_verbatim(std::string_view& text, std::string_view end) {
    const std::size_t at = text.find(end);
    append_front(text, at == std::string_view::npos ? text.size() : at + end.size());
  }

  void append_tag(std::string_view& text) {
    while (!text.empty()) {
      const std::size_t stop = std::min(text.find_first_of("\"'>"), text.size() - 1);
      const char found = text[stop];
      append_front(text, stop + 1);
      if (found != '"' && found != '\'') return;
      const std::string_view value = text.substr(0, text.find(found));
      append_references(value, true);
      text.remove_prefix(value.size());
      append_front(text, std::min<std::size_t>(1, text.size()));
    }
  }

  // Copies `text`, with the value of each declared entity in its place.
  void append_references(std::string_view text, bool within_quotes) {
    while (!text.empty()) {
      append_front(text, std::min(text.find('&'), text.size()));
      if (text.empty()) return;
      const std::size_t end = text.find_first_of(";&", 1);
      const bool named = end != std::string_view::npos && text[end] == ';';
      const auto entity = named ? entities_.find(text.substr(1, end - 1)) : entities_.end();
      if (entity == entities_.end()) {
        append_front(text, 1);
        continue;
      }
      text.remove_prefix(end + 1);
      append_entity(entity->first, entity->second, within_quotes);
    }
  }

  void append_entity(const std::string& name, const Entity& entity, bool within_quotes) {
    if (entity.external) {
      if (external_.insert(name).second) {
        warn_({{file_, line()}, "", "external entity &" + name + "; is not opened"});
      }
      return;
    }
    if (depth_ == limits_.depth) {
      throw Error({file_, line()}, "entity &" + name + "; refers to itself or nests too deep");
    }
    count_expanded(kReferenceCost);
    ++depth_;
    if (within_quotes) {
      append_references(entity.quoted_value, true);
    } else {
      append_markup(entity.value);
    }
    --depth_;
  }

  void append_front(std::string_view& text, std::size_t count) {
    if (depth_ > 0) count_expanded(count);
    result_.append(text.substr(0, count));
    text.remove_prefix(count);
  }

  void count_expanded(std::size_t bytes) {
    expanded_ += bytes;
    if (expanded_ <= limits_.bytes) return;
    throw Error({file_, line()},
                "entities expand to more than " + std::to_string(limits_.bytes >> 20) + " MB");
  }

  std::size_t line() const {
    return 1 + static_cast<std::size_t>(std::ranges::count(result_, '\n'));
  }

  const EntityMap& entities_;
  const std::string& file_;
  const EntityLimits& limits_;
  const WarningHandler& warn_;
  std::string result_;
  std::set<std::string> external_;
  std::size_t expanded_ = 0;
  int depth_ = 0;
};

}  // namespace

std::string expand_entities(std::string text, const std::string& file, const EntityLimits& limits,
                            const WarningHandler& warn) {
  EntityMap entities;
  const std::string_view doctype = read_doctype(text, entities);
  if (doctype.empty()) return text;
  blank(text, static_cast<std::size_t>(doctype.data() - text.data()), doctype.size());
  if (entities.empty()) return text;
  return Expander(entities, file, limits, warn).expand(text);
}

}  // namespace libstyle::svg
