// SPDX-License-Identifier: Apache-2.0
#include "converters/common/output_pattern.h"

#include <algorithm>
#include <utility>

#include "converters/common/command.h"

namespace libstyle {
namespace {

constexpr std::string_view kName = "{name}";
constexpr std::string_view kNumber = "{number}";

// Leaves room within the 255 bytes of a file name for what the pattern puts around.
constexpr std::size_t kLongestName = 200;

std::string safe_name(std::string_view name) {
  if (name.size() > kLongestName) {
    std::size_t end = kLongestName;
    while (end > 0 && (name[end] & 0xc0) == 0x80) --end;  // not inside a UTF-8 character
    name = name.substr(0, end);
  }
  if (name.empty()) return "unnamed";
  std::string safe(name);
  const auto is_unsafe = [](char c) {
    return c == '/' || c == 0x7f || static_cast<unsigned char>(c) < 0x20;
  };
  std::ranges::replace_if(safe, is_unsafe, '_');
  if (safe.front() == '.') safe.front() = '_';
  return safe;
}

// The placeholder that begins at `at`, or nothing when the brace there is no placeholder.
std::string_view placeholder_at(std::string_view pattern, std::size_t at) {
  for (const std::string_view known : {kName, kNumber}) {
    if (pattern.substr(at).starts_with(known)) return known;
  }
  return {};
}

}  // namespace

OutputPattern::OutputPattern(std::string pattern) : pattern_(std::move(pattern)) {
  for (std::size_t at = pattern_.find('{'); at < pattern_.size(); at = pattern_.find('{', at + 1)) {
    if (placeholder_at(pattern_, at).empty()) {
      throw UsageError("'" + pattern_ + "': only {name} and {number} can stand in braces");
    }
    takes_several_ = true;
  }
}

std::string OutputPattern::next(std::string_view document_name, std::size_t number) {
  if (!takes_several_) return pattern_;
  const std::string name = safe_name(document_name);
  std::string output = expanded(name, number);
  std::size_t& uses = uses_[output];
  // Names with a number behind may be taken too, by documents that are called so.
  for (++uses; uses > 1; ++uses) {
    const std::string numbered = expanded(name + "-" + std::to_string(uses), number);
    if (!uses_.contains(numbered)) {
      uses_[numbered] = 1;
      return numbered;
    }
  }
  return output;
}

std::string OutputPattern::expanded(std::string_view name, std::size_t number) const {
  std::string output;
  for (std::size_t at = 0; at < pattern_.size();) {
    const std::string_view placeholder = placeholder_at(pattern_, at);
    if (placeholder == kName) {
      output += name;
    } else if (placeholder == kNumber) {
      output += std::to_string(number);
    } else {
      output += pattern_[at];
    }
    at += std::max<std::size_t>(placeholder.size(), 1);
  }
  return output == "-" ? "./-" : output;  // a document is never sent to stdout by its name
}

}  // namespace libstyle
