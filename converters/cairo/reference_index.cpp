// SPDX-License-Identifier: Apache-2.0
#include <variant>

#include "converters/cairo/canvas.h"

namespace libstyle {
namespace {

template <typename... Types>
const RecordBase* as_one_of(const Record& record) {
  const RecordBase* found = nullptr;
  ((found = std::holds_alternative<Types>(record) ? &std::get<Types>(record) : found), ...);
  return found;
}

}  // namespace

ReferenceIndex::ReferenceIndex(const Document& document) : document_(document) {
  for (std::size_t i = 0; i < document.records.size(); ++i) {
    const Record& record = document.records[i];
    const RecordBase* target =
        as_one_of<GroupRecord, ElementRecord, ClipRecord, GradientRecord>(record);
    if (target && !target->id.empty()) places_.emplace(target->id, i);
    if (const auto* clip = std::get_if<ClipRecord>(&record)) clip_places_.emplace(clip, i);
  }
}

std::size_t ReferenceIndex::find(std::string_view id) const {
  const auto found = places_.find(id);
  return found == places_.end() ? kNone : found->second;
}

std::size_t ReferenceIndex::container(std::string_view id, std::size_t from) const {
  if (id.empty()) return kNone;
  const std::size_t place = find(id);
  if (place == kNone || place >= from) return kNone;
  return as_one_of<GroupRecord, ElementRecord>(document_.records[place]) ? place : kNone;
}

const ClipRecord* ReferenceIndex::clip(std::string_view id, const ClipRecord* from) const {
  const std::size_t place = find(id);
  if (place == kNone || (from && place >= clip_places_.at(from))) return nullptr;
  return std::get_if<ClipRecord>(&document_.records[place]);
}

const GradientRecord* ReferenceIndex::gradient(std::string_view id) const {
  const std::size_t place = find(id);
  return place == kNone ? nullptr : std::get_if<GradientRecord>(&document_.records[place]);
}

}  // namespace libstyle
