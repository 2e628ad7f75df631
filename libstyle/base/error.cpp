// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/error.h"

#include <utility>

namespace libstyle {

std::string to_prefix(const Place& place) {
  if (place.file.empty()) return {};
  if (place.line == 0) return place.file + ": ";
  return place.file + ":" + std::to_string(place.line) + ": ";
}

Error::Error(const std::string& message) : Error(Place{}, message) {}

Error::Error(Place place, std::string message)
    : std::runtime_error(to_prefix(place) + message),
      place_(std::move(place)),
      message_(std::move(message)) {}

}  // namespace libstyle
