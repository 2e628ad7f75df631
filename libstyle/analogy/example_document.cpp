// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/example_document.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "libstyle/analogy/strokes.h"
#include "libstyle/base/error.h"
#include "libstyle/geometry/arc_length.h"
#include "libstyle/geometry/flatten.h"

namespace libstyle {
namespace {

constexpr double kFlatness = 1e-4;           // of the size of the drawing
constexpr std::size_t kTellingVertices = 8;  // that many are hardly the same number by chance

struct ExampleCurve {
  Polyline polyline;
  std::vector<LineFeature> features;
  std::vector<std::vector<double>> values;  // of the features at each point
  std::vector<double> vertices;  // the place of each point among the vertices of its path
  std::vector<double> t;         // given along the curve; may be empty
  std::size_t vertex_count = 0;
};

std::size_t count_vertices(const FlattenedSubpath& flat) {
  return flat.places.back().end_vertex - flat.places.front().start_vertex + 1;
}

void append_curves(std::vector<ExampleCurve>& curves, const PathRecord& record, double tolerance) {
  const std::vector<double>* t = record.along.find("t");
  for (const FlattenedSubpath& flat : flatten(record.path, tolerance)) {
    if (flat.polyline.points.size() < 2 || !(arc_length(flat.polyline) > 0)) continue;
    ExampleCurve curve{flat.polyline,       line_features(record.along), {}, {}, {},
                       count_vertices(flat)};
    for (const LineFeature& feature : curve.features) {
      curve.values.push_back(values_along(flat.places, feature_values(record.along, feature)));
      round_to_writable(curve.values.back(), feature);  // as a style document keeps them
    }
    const std::size_t first = flat.places.front().start_vertex;
    for (const PathPlace& place : flat.places) {
      curve.vertices.push_back(static_cast<double>(place.start_vertex - first) + place.t);
    }
    if (t) curve.t = values_along(flat.places, *t);
    curves.push_back(std::move(curve));
  }
}

std::vector<ExampleCurve> curves_of(const Document& document) {
  const Box box = control_box(document);
  const double size = std::max(box.width(), box.height());
  std::vector<ExampleCurve> curves;
  if (!(size > 0)) return curves;
  for (const Record& record : document.records) {
    if (const auto* path = std::get_if<PathRecord>(&record)) {
      append_curves(curves, *path, kFlatness * size);
    }
  }
  return curves;
}

std::string counted(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " curve" : " curves");
}

// What all the curves have.
std::vector<LineFeature> features_of(std::span<const ExampleCurve> curves) {
  std::vector<std::vector<LineFeature>> each;
  for (const ExampleCurve& curve : curves) each.push_back(curve.features);
  return common_features(each);
}

void add_features(ExamplePair& pair, const ExampleCurve& filtered,
                  const std::vector<LineFeature>& features) {
  pair.features = features;
  pair.filtered.channels.clear();
  for (const LineFeature& feature : features) {
    const auto own = std::ranges::find(filtered.features, feature);
    pair.filtered.channels.push_back(
        filtered.values[static_cast<std::size_t>(own - filtered.features.begin())]);
  }
}

SampledCurve with_parameter(const ExampleCurve& curve, const std::vector<double>& t) {
  return {curve.polyline, t, {}};
}

ExamplePair make_pair(const ExampleCurve& unfiltered, const ExampleCurve& filtered) {
  ExamplePair pair;
  pair.same_parameter = true;
  const auto rises = [](const std::vector<double>& t) {
    return !t.empty() && std::ranges::is_sorted(t);
  };
  const bool open = !unfiltered.polyline.closed && !filtered.polyline.closed;
  if (open && rises(unfiltered.t) && rises(filtered.t)) {
    pair.unfiltered = with_parameter(unfiltered, unfiltered.t);
    pair.filtered = with_parameter(filtered, filtered.t);
  } else if (open && unfiltered.vertex_count == filtered.vertex_count &&
             filtered.vertex_count >= kTellingVertices) {
    pair.unfiltered = with_parameter(unfiltered, unfiltered.vertices);
    pair.filtered = with_parameter(filtered, filtered.vertices);
  } else {
    pair.unfiltered = with_length_parameter(unfiltered.polyline);
    pair.filtered = with_length_parameter(filtered.polyline);
    pair.same_parameter = false;
  }
  return pair;
}

std::vector<Polyline> polylines_of(std::span<const ExampleCurve> curves) {
  std::vector<Polyline> result;
  for (const ExampleCurve& curve : curves) result.push_back(curve.polyline);
  return result;
}

// Every filtered curve is a stroke of the unfiltered one that it lies along.
std::vector<ExamplePair> pairs_of_strokes(std::span<const ExampleCurve> before,
                                          std::span<const ExampleCurve> after) {
  const std::vector<LineFeature> features = features_of(after);
  const std::vector<std::size_t> lines =
      lines_of_strokes(polylines_of(before), polylines_of(after));
  std::vector<ExamplePair> pairs;
  for (std::size_t line = 0; line < before.size(); ++line) {
    std::optional<ExamplePair> pair;
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (lines[i] != line) continue;
      ExamplePair own = make_pair(before[line], after[i]);
      add_features(own, after[i], features);
      if (pair) {
        pair->others.push_back(std::move(own.filtered));
      } else {
        pair = std::move(own);
      }
    }
    if (!pair) {
      throw Error("no stroke of the filtered example lies along the unfiltered curve " +
                  std::to_string(line + 1) + "; draw each of them");
    }
    pairs.push_back(std::move(*pair));
  }
  return pairs;
}

}  // namespace

PathRecord painted_like(const Document& example) {
  PathRecord path;
  for (const Record& record : example.records) {
    const auto* first = std::get_if<PathRecord>(&record);
    if (!first) continue;
    path.style = first->style;
    path.classes = first->classes;
    break;
  }
  // What belongs to the place of the example, or to an area, is left behind.
  path.style.fill = NoPaint{};
  if (!path.style.stroke || std::holds_alternative<PaintReference>(*path.style.stroke)) {
    path.style.stroke = Color{};
  }
  path.style.stroke_transform.reset();
  path.style.hidden = false;
  return path;
}

std::vector<ExamplePair> example_pairs(const Document* unfiltered, const Document& filtered) {
  const std::vector<ExampleCurve> after = curves_of(filtered);
  if (after.empty())
    throw Error("the filtered example has no curve; draw one that shows the style");
  const std::vector<LineFeature> features = features_of(after);
  std::vector<ExamplePair> pairs;
  if (!unfiltered) {
    for (const ExampleCurve& curve : after) {
      pairs.push_back({std::nullopt, with_length_parameter(curve.polyline), false});
      add_features(pairs.back(), curve, features);
    }
    return pairs;
  }
  const std::vector<ExampleCurve> before = curves_of(*unfiltered);
  if (before.empty()) {
    throw Error(
        "the unfiltered example has no curve; draw one for each filtered one, or leave it out");
  }
  if (before.size() < after.size()) return pairs_of_strokes(before, after);
  if (before.size() != after.size()) {
    throw Error("the unfiltered example has " + counted(before.size()) + ", the filtered one " +
                counted(after.size()) + "; draw one for one, in the same order");
  }
  for (std::size_t i = 0; i < after.size(); ++i) {
    pairs.push_back(make_pair(before[i], after[i]));
    add_features(pairs.back(), after[i], features);
  }
  return pairs;
}

}  // namespace libstyle
