// SPDX-License-Identifier: Apache-2.0
#include "libstyle/base/number.h"

#include <fmt/compile.h>

#include <cassert>
#include <charconv>
#include <cmath>
#include <iterator>

namespace libstyle {

void append_number(std::string& text, double value) {
  assert(std::isfinite(value));
  char buffer[32];
  char* end = fmt::format_to(buffer, FMT_COMPILE("{}"), value + 0.0);  // + 0.0 drops the sign of -0
  text.append(buffer, end);
}

bool take_number(std::string_view& text, double& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || !std::isfinite(value)) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

}  // namespace libstyle
