// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/nesting.h"

#include <map>
#include <string_view>

namespace libstyle {
namespace {

const RecordBase* as_container(const Record& record) {
  if (const auto* group = std::get_if<GroupRecord>(&record)) return group;
  return std::get_if<ElementRecord>(&record);
}

std::string_view parent_of(const Record& record) {
  const RecordBase* base = base_of(record);
  return base ? std::string_view(base->parent) : std::string_view();
}

}  // namespace

Containers::Containers(const Document& document) {
  std::map<std::string_view, std::size_t> places;
  containers_.reserve(document.records.size());
  for (std::size_t i = 0; i < document.records.size(); ++i) {
    const Record& record = document.records[i];
    const auto parent = places.find(parent_of(record));
    containers_.push_back(parent == places.end() ? kNone : parent->second);
    const RecordBase* container = as_container(record);
    if (container && !container->id.empty()) places.emplace(container->id, i);
  }
}

// A container stands before its members, so of two that differ the later one is not around the
// earlier.
void Nesting::enter(std::size_t place) {
  std::vector<std::size_t> to_open;
  while (place != innermost()) {
    if (!open_.empty() && (place == Containers::kNone || place < innermost())) {
      close_handler_(open_.back());
      open_.pop_back();
    } else {
      to_open.push_back(place);
      place = containers_.of(place);
    }
  }
  for (; !to_open.empty(); to_open.pop_back()) {
    open_.push_back(to_open.back());
    open_handler_(open_.back());
  }
}

}  // namespace libstyle
