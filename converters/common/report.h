// SPDX-License-Identifier: Apache-2.0
// What a run had to say, for other programs: the file of --report. Its form is described in
// svg2curves(1); a program that has more to tell adds lists beside "messages".
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "converters/common/json_object.h"
#include "libstyle/base/error.h"

namespace libstyle {

enum class Severity : std::uint8_t { kWarning, kError };

class Report {
 public:
  // Adds to a list, which is there from then on.
  void add_to_list(std::string_view name, const JsonObject& item);

  // `id` may be empty.
  void add(Severity severity, const Place& place, std::string_view id, std::string_view message);

  // All of it as JSON: one object, each message and each item of a list on a line of its own.
  // Always UTF-8.
  std::string to_json(std::string_view program, int exit_code) const;

 private:
  struct List {
    std::string name;
    std::string items;  // as JSON, with commas between
  };

  List& list(std::string_view name);

  List messages_{"messages", {}};
  std::vector<List> lists_;
  std::size_t warnings_ = 0;
  std::size_t errors_ = 0;
};

}  // namespace libstyle
