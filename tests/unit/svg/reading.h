// SPDX-License-Identifier: Apache-2.0
// Reads SVG text in tests, and finds what was drawn.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "converters/svg/svg_reader.h"
#include "libstyle/geometry/path_data.h"

namespace libstyle::svg {

struct Reading {
  Document document;
  std::vector<Warning> warnings;

  std::vector<const PathRecord*> paths() const { return all<PathRecord>(); }
  std::vector<const GroupRecord*> groups() const { return all<GroupRecord>(); }
  std::vector<const GradientRecord*> gradients() const { return all<GradientRecord>(); }
  std::vector<const ClipRecord*> clips() const { return all<ClipRecord>(); }

  // The one record of its kind, as most tests draw one thing.
  const PathRecord& path() const { return only(paths()); }
  const GroupRecord& group() const { return only(groups()); }

  std::string path_data(std::size_t index = 0) const {
    return to_path_data(paths().at(index)->path);
  }

  // "line #id message" of each warning.
  std::vector<std::string> warning_texts() const {
    std::vector<std::string> texts;
    for (const Warning& warning : warnings) {
      const std::string id = warning.id.empty() ? "" : "#" + warning.id + " ";
      texts.push_back(std::to_string(warning.place.line) + " " + id + warning.message);
    }
    return texts;
  }

 private:
  template <typename Kind>
  std::vector<const Kind*> all() const {
    std::vector<const Kind*> found;
    for (const Record& record : document.records) {
      if (const auto* const match = std::get_if<Kind>(&record)) found.push_back(match);
    }
    return found;
  }

  template <typename Kind>
  static const Kind& only(const std::vector<const Kind*>& found) {
    EXPECT_EQ(found.size(), 1U);
    static const Kind kNothing;
    return found.empty() ? kNothing : *found.front();
  }
};

inline Reading read_file(std::string_view text, const SvgReadOptions& options = {}) {
  Reading reading;
  reading.document = read_svg(std::string(text), "test.svg", options,
                              [&](const Warning& warning) { reading.warnings.push_back(warning); });
  return reading;
}

// Reads `inside` on a page of 100 by 100 px.
inline Reading read(std::string_view inside) {
  return read_file(
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink'"
      " width='100' height='100'>" +
      std::string(inside) + "</svg>");
}

// What Error says, or "" when reading succeeds.
inline std::string read_error(const std::string& text, const SvgReadOptions& options = {}) {
  try {
    read_file(text, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace libstyle::svg
