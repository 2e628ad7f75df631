// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/bytes.h"

#include <algorithm>

namespace libstyle {

std::size_t TextSource::read(std::span<char> buffer) {
  const std::size_t count = std::min(buffer.size(), rest_.size());
  std::copy_n(rest_.begin(), count, buffer.begin());
  rest_.remove_prefix(count);
  return count;
}

}  // namespace libstyle
