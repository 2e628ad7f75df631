// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/synthesis_document.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libstyle/analogy/example_document.h"
#include "libstyle/analogy/smooth_curve.h"
#include "libstyle/geometry/arc_length.h"

namespace libstyle {
namespace {

constexpr double kMargin = 0.02;  // of the longer side

}  // namespace

std::vector<ExamplePair> synthesis_examples(std::span<const ExamplePair> pairs) {
  std::vector<ExamplePair> examples;
  for (const ExamplePair& pair : pairs) {
    examples.push_back({.unfiltered = {}, .filtered = pair.filtered, .features = pair.features});
    for (const SampledCurve& stroke : pair.others) {
      examples.push_back({.unfiltered = {}, .filtered = stroke, .features = pair.features});
    }
  }
  return examples;
}

Document synthesized_document(const CurveSynthesis& style, const SynthesizedCurve& made,
                              const Document& example) {
  StyledCurve drawn;
  drawn.curve = made.curve;
  drawn.features = made.features;
  drawn.pinned = made.pinned;
  Box box;
  for (const Point p : drawn.curve.points) box.include(p);
  PathRecord path = painted_like(example);
  if (made.is_placed) {
    box.include(Point{});
    box.low = {};
  }
  const Vector size = box.high - box.low;
  const double margin = std::ceil(kMargin * std::max(size.x, size.y) + path.style.stroke_width);
  const double before = made.is_placed ? 0 : margin;
  for (Point& p : drawn.curve.points) p += Point{before, before} - box.low;
  drawn.lengths = cumulative_lengths(drawn.curve);

  const SmoothCurve smooth =
      smooth_curve(drawn, arc_length(drawn.curve), fit_tolerances(style.example(), 1));
  path.path = smooth.path;
  set_features(path.along, style.example().features(), smooth.features);
  Document document;
  document.header.name = example.header.name;
  document.header.width = std::ceil(size.x + (before + margin));
  document.header.height = std::ceil(size.y + (before + margin));
  document.records.emplace_back(std::move(path));
  return document;
}

}  // namespace libstyle
