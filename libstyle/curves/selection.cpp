// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/selection.h"

#include <algorithm>
#include <unordered_map>

#include "libstyle/base/error.h"
#include "libstyle/curves/nesting.h"

namespace libstyle {
namespace {

constexpr std::string_view kLayerPrefix = "layer:";
constexpr std::string_view kBlank = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) + 1 - first);
}

bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != std::string_view::npos;
       at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || words[at - 1] == ' ';
    if (begins && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

bool is_drawn(const Record& record) {
  return std::holds_alternative<PathRecord>(record) ||
         std::holds_alternative<GroupRecord>(record) ||
         std::holds_alternative<ElementRecord>(record);
}

// The records of a document that stay.
class Selection {
 public:
  Selection(const Document& document, const RecordSelector& selector)
      : document_(document), containers_(document), kept_(document.records.size()) {
    const std::vector<std::size_t> selected = selected_by(document, {&selector, 1});
    for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] = selected[i] != kNotSelected;
    any_ = std::ranges::find(kept_, true) != kept_.end();
    keep_what_is_needed();
  }

  bool any() const { return any_; }
  const std::vector<bool>& kept() const { return kept_; }

 private:
  // References reach back only, but those from records that are not drawn, which may stand
  // anywhere.
  void keep_what_is_needed() {
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const RecordBase* base = base_of(document_.records[i]);
      if (base && !base->id.empty()) places_.emplace(base->id, i);
    }
    for (std::size_t i = kept_.size(); i-- > 0;) {
      if (kept_[i])
        std::visit([&](const auto& record) { keep_needs(record, i); }, document_.records[i]);
    }
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      std::visit([&](const auto& record) { keep_remarks(record, i); }, document_.records[i]);
    }
  }

  void keep(std::string_view id) {
    const auto found = places_.find(id);
    if (found != places_.end()) kept_[found->second] = true;
  }

  void keep_paint(const std::optional<Paint>& paint) {
    if (!paint) return;
    if (const auto* reference = std::get_if<PaintReference>(&*paint)) keep(reference->id);
  }

  template <typename Known>
  void keep_needs(const Known& record, std::size_t place) {
    if (containers_.of(place) != Containers::kNone) kept_[containers_.of(place)] = true;
    if constexpr (std::is_same_v<Known, PathRecord>) {
      keep(record.clip);
      keep_paint(record.style.fill);
      keep_paint(record.style.stroke);
    } else if constexpr (std::is_same_v<Known, GroupRecord>) {
      keep(record.clip);
    } else if constexpr (std::is_same_v<Known, ClipRecord>) {
      keep(record.clip);
      for (const ClipPart& part : record.parts) keep(part.clip);
    }
  }

  bool is_kept(std::string_view id) const {
    const auto found = places_.find(id);
    return found != places_.end() && kept_[found->second];
  }

  template <typename Known>
  void keep_remarks(const Known& record, std::size_t place) {
    if constexpr (requires { record.curve; }) {
      kept_[place] = is_kept(record.curve);
    } else if constexpr (std::is_same_v<Known, LabelRecord>) {
      kept_[place] = is_kept(record.of);
    } else if constexpr (std::is_same_v<Known, UnknownRecord>) {
      kept_[place] = true;
    }
  }

  const Document& document_;
  const Containers containers_;
  std::unordered_map<std::string_view, std::size_t> places_;
  std::vector<bool> kept_;
  bool any_ = false;
};

}  // namespace

RecordSelector::RecordSelector(std::string_view text, BareWord bare) {
  while (true) {
    const std::size_t comma = text.find(',');
    terms_.push_back(parse_term(trimmed(text.substr(0, comma)), bare));
    if (comma == std::string_view::npos) return;
    text.remove_prefix(comma + 1);
  }
}

RecordSelector::Term RecordSelector::parse_term(std::string_view text, BareWord bare) {
  Term term;
  std::string_view name = text;
  if (text.starts_with('#')) {
    term.kind = Term::Kind::kId;
    name.remove_prefix(1);
  } else if (text.starts_with('.')) {
    term.kind = Term::Kind::kClass;
    name.remove_prefix(1);
  } else if (text.starts_with(kLayerPrefix)) {
    term.kind = Term::Kind::kLayer;
    name = trimmed(name.substr(kLayerPrefix.size()));
  } else {
    term.kind = bare == BareWord::kElement ? Term::Kind::kShape : Term::Kind::kAnything;
  }
  constexpr std::string_view kNotInLabels = "#.:>+~*[]", kNotInNames = " #.:>+~*[]";
  const std::string_view excluded = term.kind == Term::Kind::kAnything ? kNotInLabels : kNotInNames;
  const bool is_plain = term.kind == Term::Kind::kLayer || term.kind == Term::Kind::kId ||
                        name.find_first_of(excluded) == std::string_view::npos;
  if (name.empty() || !is_plain) {
    throw Error("\"" + std::string(text) + "\" is not #ID, .CLASS, layer:NAME or " +
                (bare == BareWord::kElement ? "the name of an element such as rect" : "a name"));
  }
  term.name = name;
  return term;
}

bool RecordSelector::matches(const Record& record) const {
  return std::ranges::any_of(terms_, [&](const Term& term) { return matches(term, record); });
}

bool RecordSelector::matches(const Term& term, const Record& record) {
  const RecordBase* base = base_of(record);
  if (!base) return false;
  const auto* group = std::get_if<GroupRecord>(&record);
  const auto* path = std::get_if<PathRecord>(&record);
  const bool has_id = given_id(base->id) == term.name;
  const bool has_class = has_word(base->classes, term.name);
  const bool has_label = base->label == term.name;
  const bool has_shape =
      path && (path->shape.empty() ? PathRecord::kType : path->shape) == term.name;
  switch (term.kind) {
    case Term::Kind::kId:
      return has_id;
    case Term::Kind::kClass:
      return has_class;
    case Term::Kind::kLayer:
      return group && group->layer && (base->label.empty() ? has_id : has_label);
    case Term::Kind::kShape:
      return has_shape;
    case Term::Kind::kAnything:
      return has_id || has_class || has_label || has_shape;
  }
  return false;
}

// Containers stand before their members.
std::vector<std::size_t> selected_by(const Document& document,
                                     std::span<const RecordSelector> selectors) {
  const Containers containers(document);
  std::vector<std::size_t> result(document.records.size(), kNotSelected);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Record& record = document.records[i];
    if (!is_drawn(record)) continue;
    const std::size_t around = containers.of(i);
    if (around != Containers::kNone) result[i] = result[around];
    for (std::size_t j = 0; j < selectors.size(); ++j) {
      if (selectors[j].matches(record)) result[i] = j;
    }
  }
  return result;
}

bool keep_selected(Document& document, const RecordSelector& selector) {
  const Selection selection(document, selector);
  std::size_t place = 0;
  std::erase_if(document.records, [&](const Record&) { return !selection.kept()[place++]; });
  return selection.any();
}

}  // namespace libstyle
