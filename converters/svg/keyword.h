// SPDX-License-Identifier: Apache-2.0
// Values of properties that are one of a few words.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "converters/svg/scanner.h"

namespace libstyle::svg {

template <typename Value>
using Keywords = std::initializer_list<std::pair<std::string_view, Value>>;

template <typename Value>
std::optional<Value> find_keyword(std::string_view text, Keywords<Value> keywords) {
  for (const auto& [name, value] : keywords) {
    if (equal_ignoring_case(text, name)) return value;
  }
  return std::nullopt;
}

// The one of `words` that a text is.
inline std::optional<std::string_view> find_word(std::string_view text,
                                                 std::initializer_list<std::string_view> words) {
  for (const std::string_view word : words) {
    if (equal_ignoring_case(text, word)) return word;
  }
  return std::nullopt;
}

}  // namespace libstyle::svg
