// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/style_document.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "libstyle/analogy/example_document.h"
#include "libstyle/analogy/line_features.h"
#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/path_segments.h"

namespace libstyle {
namespace {

constexpr std::string_view kVersionKey = "style";
constexpr std::string_view kVersion = "1";
constexpr std::string_view kFiltered = "filtered", kUnfiltered = "unfiltered", kStroke = "stroke";
constexpr std::string_view kParameter = "t";
constexpr Color kPlainColor = {160, 160, 160};  // of unfiltered curves, when one looks at a style

const Extra* version_of(const Document& document) {
  const auto extra = std::ranges::find(document.header.extras, kVersionKey, &Extra::key);
  return extra == document.header.extras.end() ? nullptr : &*extra;
}

PathRecord record_of(const SampledCurve& curve, std::span<const LineFeature> features,
                     std::string_view label, PathRecord paint) {
  PathRecord record = std::move(paint);
  record.label = label;
  record.path = to_path(curve.polyline);
  set_features(record.along, features, curve.channels);
  return record;
}

void add_parameter(PathRecord& record, const SampledCurve& curve) {
  record.along.channels.push_back({std::string(kParameter), curve.t});
}

void append_pair(Document& document, const ExamplePair& pair, const PathRecord& paint,
                 const PathRecord& plain_paint) {
  PathRecord filtered = record_of(pair.filtered, pair.features, kFiltered, paint);
  if (!pair.unfiltered) {
    document.records.emplace_back(std::move(filtered));
    return;
  }
  PathRecord unfiltered = record_of(*pair.unfiltered, {}, kUnfiltered, plain_paint);
  if (pair.same_parameter && pair.others.empty()) {
    add_parameter(filtered, pair.filtered);
    add_parameter(unfiltered, *pair.unfiltered);
  }
  document.records.emplace_back(std::move(filtered));
  document.records.emplace_back(std::move(unfiltered));
  for (const SampledCurve& stroke : pair.others) {
    document.records.emplace_back(record_of(stroke, pair.features, kStroke, paint));
  }
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

SampledCurve curve_of(const PathRecord& record, std::span<const LineFeature> features) {
  SampledCurve curve = curve_of(record);
  for (const LineFeature& feature : features) {
    curve.channels.push_back(feature_values(record.along, feature));
  }
  return curve;
}

// What goes along all filtered curves and strokes.
std::vector<LineFeature> features_of(const Document& style) {
  std::vector<std::vector<LineFeature>> each;
  for (const Record& record : style.records) {
    const auto* path = std::get_if<PathRecord>(&record);
    if (path && path->label != kUnfiltered) each.push_back(line_features(path->along));
  }
  return common_features(each);
}

void add_unfiltered(ExamplePair& pair, const PathRecord& unfiltered, const PathRecord& filtered) {
  if (has_parameter(unfiltered) != has_parameter(filtered)) {
    throw Error({{}, unfiltered.line}, "\"t\" is along one path of a pair and not along the other");
  }
  pair.unfiltered = curve_of(unfiltered);
  pair.same_parameter = has_parameter(unfiltered);
}

void add_stroke(ExamplePair& pair, const PathRecord& stroke,
                std::span<const LineFeature> features) {
  if (pair.same_parameter || has_parameter(stroke)) {
    throw Error({{}, stroke.line}, "several strokes of one path of a style have no \"t\"");
  }
  pair.others.push_back(curve_of(stroke, features));
}

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
  for (const ExamplePair& pair : pairs) append_pair(document, pair, paint, plain_paint);
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
  const std::vector<LineFeature> features = features_of(style);
  std::vector<ExamplePair> pairs;
  const PathRecord* filtered = nullptr;  // the record before, if it waits for its unfiltered curve
  for (const Record& record : style.records) {
    const auto* path = std::get_if<PathRecord>(&record);
    if (!path) continue;
    if (path->label == kFiltered) {
      pairs.push_back({std::nullopt, curve_of(*path, features), false, features});
      filtered = path;
    } else if (path->label == kUnfiltered && filtered) {
      add_unfiltered(pairs.back(), *path, *filtered);
      filtered = nullptr;
    } else if (path->label == kStroke && !pairs.empty() && pairs.back().unfiltered) {
      add_stroke(pairs.back(), *path, features);
    } else {
      throw Error({{}, path->line},
                  "a path of a style has the label \"filtered\", or \"unfiltered\" after one that "
                  "has the label \"filtered\", or \"stroke\" after these two");
    }
  }
  if (pairs.empty()) throw Error("the style has no path with the label \"filtered\"");
  return pairs;
}

}  // namespace libstyle
