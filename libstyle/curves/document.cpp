// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/document.h"

#include <algorithm>

namespace libstyle {

const RecordBase* base_of(const Record& record) {
  return std::visit(
      [](const auto& known) -> const RecordBase* {
        if constexpr (std::is_base_of_v<RecordBase, std::decay_t<decltype(known)>>) {
          return &known;
        } else {
          return nullptr;
        }
      },
      record);
}

const std::vector<double>* AlongValues::find(std::string_view name) const {
  const auto found = std::ranges::find(channels, name, &Channel::name);
  return found == channels.end() ? nullptr : &found->values;
}

Box control_box(const Document& document) {
  Box box;
  for (const Record& record : document.records) {
    if (const auto* path = std::get_if<PathRecord>(&record)) box.include(path->path.control_box());
  }
  return box;
}

}  // namespace libstyle
