// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/style_document.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "libstyle/analogy/example_document.h"
#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/path_segments.h"

namespace libstyle {
namespace {

constexpr std::string_view kVersionKey = "style";
constexpr std::string_view kVersion = "1";
constexpr std::string_view kFiltered = "filtered", kUnfiltered = "unfiltered";
constexpr std::string_view kParameter = "t";
constexpr Color kPlainColor = {160, 160, 160};  // of unfiltered curves, when one looks at a style

const Extra* version_of(const Document& document) {
  const auto extra = std::ranges::find(document.header.extras, kVersionKey, &Extra::key);
  return extra == document.header.extras.end() ? nullptr : &*extra;
}

PathRecord record_of(const SampledCurve& curve, bool has_parameter, std::string_view label,
                     PathRecord paint) {
  PathRecord record = std::move(paint);
  record.label = label;
  record.path = to_path(curve.polyline);
  if (has_parameter) record.along.channels.push_back({std::string(kParameter), curve.t});
  return record;
}

// A path of one subpath that consists of lines, as the curve it was.
SampledCurve curve_of(const PathRecord& record) {
  const auto fail = [&](const std::string& what) { return Error({{}, record.line}, what); };
  SampledCurve curve;
  for (const PathCommand command : record.path.commands()) {
    const bool starts = command == PathCommand::kMove;
    if (command == PathCommand::kCubic || (starts && !curve.polyline.points.empty())) {
      throw fail("a path of a style is one line of straight pieces");
    }
    if (command == PathCommand::kClose) {
      curve.polyline.closed = true;
    } else {
      curve.polyline.points.push_back(record.path.points()[curve.polyline.points.size()]);
    }
  }
  if (curve.polyline.points.empty() || !(arc_length(curve.polyline) > 0)) {
    throw fail("a path of a style has no length");
  }
  const std::vector<double>* t = record.along.find(kParameter);
  if (!t) return with_length_parameter(std::move(curve.polyline));
  if (!std::ranges::is_sorted(*t)) throw fail("\"t\" falls along a path of a style");
  if (curve.polyline.closed) throw fail("a path of a style with \"t\" is open");
  curve.t = *t;
  return curve;
}

bool has_parameter(const PathRecord& record) { return record.along.find(kParameter) != nullptr; }

}  // namespace

Document style_document(std::span<const ExamplePair> pairs, const Document& filtered) {
  Document document;
  document.header.name = filtered.header.name;
  document.header.width = filtered.header.width;
  document.header.height = filtered.header.height;
  document.header.extras.push_back({std::string(kVersionKey), std::string(kVersion)});
  const PathRecord paint = painted_like(filtered);
  PathRecord plain_paint;
  plain_paint.style.stroke = kPlainColor;
  for (const ExamplePair& pair : pairs) {
    const bool is_tied = pair.unfiltered && pair.same_parameter;
    document.records.emplace_back(record_of(pair.filtered, is_tied, kFiltered, paint));
    if (!pair.unfiltered) continue;
    document.records.emplace_back(record_of(*pair.unfiltered, is_tied, kUnfiltered, plain_paint));
  }
  return document;
}

bool is_style_document(const Document& document) { return version_of(document) != nullptr; }

std::vector<ExamplePair> style_pairs(const Document& style) {
  const Extra* version = version_of(style);
  if (!version) throw Error("is not a style; make one with --save-style");
  if (version->json != kVersion) {
    throw Error({{}, style.header.line}, "is a style of version " + version->json +
                                             ", but only version " + std::string(kVersion) +
                                             " is known; make it again with --save-style");
  }
  std::vector<ExamplePair> pairs;
  const PathRecord* filtered = nullptr;  // the record before, if it waits for its unfiltered curve
  for (const Record& record : style.records) {
    const auto* path = std::get_if<PathRecord>(&record);
    if (!path) continue;
    if (path->label == kFiltered) {
      pairs.push_back({std::nullopt, curve_of(*path), false});
      filtered = path;
    } else if (path->label == kUnfiltered && filtered) {
      if (has_parameter(*path) != has_parameter(*filtered)) {
        throw Error({{}, path->line}, "\"t\" is along one path of a pair and not along the other");
      }
      pairs.back().unfiltered = curve_of(*path);
      pairs.back().same_parameter = has_parameter(*path);
      filtered = nullptr;
    } else {
      throw Error({{}, path->line},
                  "a path of a style has the label \"filtered\", or \"unfiltered\" after one that "
                  "has the label \"filtered\"");
    }
  }
  if (pairs.empty()) throw Error("the style has no path with the label \"filtered\"");
  return pairs;
}

}  // namespace libstyle
