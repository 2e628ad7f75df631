// SPDX-License-Identifier: Apache-2.0
#include "libstyle/curves/document.h"

#include <algorithm>

namespace libstyle {

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
