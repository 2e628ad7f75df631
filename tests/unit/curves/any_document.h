// SPDX-License-Identifier: Apache-2.0
// Random documents that use every record, every key and every kind of value.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "libstyle/curves/document.h"

namespace libstyle {

Document any_document(std::uint64_t seed);

std::string to_stream(const std::vector<Document>& documents);

}  // namespace libstyle
