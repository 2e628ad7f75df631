// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/record_ids.h"

#include <algorithm>

#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

const std::string kNone;

// Records that stand in metadata rather than as elements keep their id as it is.
bool is_element(const Record& record) {
  return std::holds_alternative<PathRecord>(record) ||
         std::holds_alternative<GroupRecord>(record) ||
         std::holds_alternative<ElementRecord>(record) ||
         std::holds_alternative<GradientRecord>(record) ||
         std::holds_alternative<ClipRecord>(record);
}

// Gradients and clips are referred to by url(#id), which some characters would end.
bool is_referred_to_by_url(const Record& record) {
  return std::holds_alternative<GradientRecord>(record) ||
         std::holds_alternative<ClipRecord>(record);
}

// A container is kept apart by its id, which may be all that it says. One that nobody named says
// something else.
bool is_container(const Record& record) {
  return std::holds_alternative<GroupRecord>(record) ||
         std::holds_alternative<ElementRecord>(record);
}

// An id must not hold what XML cannot, nor, for url(#id), what would end the reference.
std::string wanted_id(const Record& record, const RecordBase& base) {
  std::string id(given_id(base.id));
  const bool in_url = is_referred_to_by_url(record);
  const auto is_special = [in_url](char c) {
    if (static_cast<unsigned char>(c) < ' ') return true;
    return in_url && std::string_view(" \"'()\\").find(c) != std::string_view::npos;
  };
  std::ranges::replace_if(id, is_special, '_');
  return id;
}

std::string_view type_of(const Record& record) {
  return std::holds_alternative<GradientRecord>(record) ? "gradient"
         : std::holds_alternative<ClipRecord>(record)   ? "clip"
                                                        : "curve";
}

// The ids that records in metadata refer to.
std::set<std::string_view> ids_in_metadata(const Document& document) {
  std::set<std::string_view> ids;
  for (const Record& record : document.records) {
    if (const auto* constraint = std::get_if<ConstraintRecord>(&record))
      ids.insert(constraint->curve);
    if (const auto* adjustment = std::get_if<AdjustmentRecord>(&record))
      ids.insert(adjustment->curve);
    if (const auto* label = std::get_if<LabelRecord>(&record)) ids.insert(label->of);
    if (const auto* seed = std::get_if<SeedRecord>(&record)) ids.insert(seed->curve);
  }
  return ids;
}

}  // namespace

RecordIds::RecordIds(const Document& document) : ids_(document.records.size()) {
  assign_given(document);
  assign_made(document);
}

const std::string& RecordIds::find(std::string_view record_id) const {
  const std::size_t found = place(record_id);
  return found == kNowhere ? kNone : ids_[found];
}

std::size_t RecordIds::place(std::string_view record_id) const {
  const auto found = places_.find(record_id);
  return found == places_.end() ? kNowhere : found->second;
}

void RecordIds::assign_given(const Document& document) {
  for (std::size_t i = 0; i < document.records.size(); ++i) {
    const RecordBase* base = base_of(document.records[i]);
    if (!base || base->id.empty() || !is_element(document.records[i])) continue;
    if (!places_.emplace(base->id, i).second || given_id(base->id) != base->id) continue;
    const std::string wanted = wanted_id(document.records[i], *base);
    if (taken_.insert(wanted).second) ids_[i] = wanted;
  }
}

void RecordIds::assign_made(const Document& document) {
  const std::set<std::string_view> in_metadata = ids_in_metadata(document);
  for (std::size_t i = 0; i < document.records.size(); ++i) {
    const Record& record = document.records[i];
    const RecordBase* base = base_of(record);
    if (!base || base->id.empty() || !is_element(record) || !ids_[i].empty()) continue;
    const std::string wanted = wanted_id(record, *base);
    if (!wanted.empty() && taken_.insert(wanted).second) {
      ids_[i] = wanted;
    } else if (is_referred_to_by_url(record) || in_metadata.contains(base->id) ||
               (is_container(record) && !wanted.empty())) {
      ids_[i] = make_numbered(record, *base, wanted);
    }
  }
}

std::string RecordIds::make_another(const Record& record) {
  const RecordBase* base = base_of(record);
  const std::string wanted = base ? wanted_id(record, *base) : "";
  return make_unique(wanted.empty() ? std::string(type_of(record)) : wanted);
}

// "chair~2" is "chair-2", if that is free.
std::string RecordIds::make_numbered(const Record& record, const RecordBase& base,
                                     const std::string& wanted) {
  if (wanted.empty()) return make_unique(std::string(type_of(record)));
  const std::string_view number = std::string_view(base.id).substr(given_id(base.id).size());
  if (number.size() > 1 && std::ranges::all_of(number.substr(1), is_digit)) {
    std::string id = wanted + '-' + std::string(number.substr(1));
    if (taken_.insert(id).second) return id;
  }
  return make_unique(wanted);
}

// The stem and a number.
std::string RecordIds::make_unique(const std::string& stem) {
  for (;;) {
    std::string id = stem + '-' + std::to_string(++counts_[stem]);
    if (taken_.insert(id).second) return id;
  }
}

}  // namespace libstyle::svg
