// SPDX-License-Identifier: Apache-2.0
// How the library says that it went on, but not quite as asked.
#pragma once

#include <functional>
#include <string>

#include "libstyle/base/error.h"

namespace libstyle {

// Something that could not be carried or had to be repaired.
struct Warning {
  Place place;
  std::string id;       // of the element or record concerned; may be empty
  std::string message;  // what happened, in one sentence without place or id
};

// Receives warnings in the order of the input. The library never prints.
using WarningHandler = std::function<void(const Warning&)>;

}  // namespace libstyle
