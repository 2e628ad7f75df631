// SPDX-License-Identifier: Apache-2.0
#include "cli/curve_analogy/through_option.h"

#include <optional>

#include "converters/common/command.h"
#include "libstyle/base/number.h"

namespace libstyle {
namespace {

// Reads `mark` and a number behind it from the front, if they are there; false if the mark is there
// alone.
bool take_marked(std::string_view& text, char mark, std::optional<double>& value) {
  if (text.empty() || text.front() != mark) return true;
  text.remove_prefix(1);
  return take_number(text, value.emplace());
}

// X,Y@T*WEIGHT; false for what has another form.
bool parse_place(std::string_view text, ConstraintRecord& place) {
  if (!take_number(text, place.position.x)) return false;
  std::optional<double> y;
  if (!take_marked(text, ',', y) || !y) return false;
  place.position.y = *y;
  return take_marked(text, '@', place.t) && take_marked(text, '*', place.weight) && text.empty();
}

ConstraintRecord checked_place(std::string_view option, std::string_view place, const char* form) {
  const auto wrong = [&](const char* what) {
    return UsageError("--through " + std::string(option) + ": " + what);
  };
  ConstraintRecord record;
  if (!parse_place(place, record)) throw wrong(form);
  if (record.t && !(*record.t >= 0 && *record.t <= 1)) {
    throw wrong("T is from 0, where the line begins, to 1, where it ends");
  }
  if (record.weight && !(*record.weight > 0)) {
    throw wrong("WEIGHT is above 0; without it the line passes exactly");
  }
  return record;
}

}  // namespace

AskedConstraint parse_through_option(std::string_view text) {
  constexpr const char* kForm = "give CURVE=X,Y or CURVE=X,Y@T, and *WEIGHT behind it if you like";
  const std::size_t equals = text.rfind('=');
  const bool has_id = equals != std::string_view::npos && equals > 0;
  ConstraintRecord record =
      checked_place(text, has_id ? text.substr(equals + 1) : std::string_view(), kForm);
  record.curve = text.substr(0, equals);
  return {record, "--through " + std::string(text)};
}

CurveConstraint parse_through_option_of_new_line(std::string_view text) {
  constexpr const char* kForm = "with --synthesize give X,Y@T, and *WEIGHT behind it if you like";
  const ConstraintRecord record = checked_place(text, text, kForm);
  if (!record.t) throw UsageError("--through " + std::string(text) + ": " + kForm);
  return {*record.t, record.position, record.weight};
}

}  // namespace libstyle
