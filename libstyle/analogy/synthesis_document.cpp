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

}  // namespace

std::vector<ExamplePair> synthesis_examples(const Document& example) {
  return example_pairs(nullptr, example);
}

Document synthesized_document(const CurveSynthesis& style, const Document& example, double length,
                              std::uint64_t variant) {
  SynthesizedCurve made = style.draw(length, 0, variant);
  StyledCurve drawn;
  drawn.curve = std::move(made.curve);
  drawn.features = std::move(made.features);
  Box box;
  for (const Point p : drawn.curve.points) box.include(p);
  PathRecord path = painted_like(example);
  const Vector size = box.high - box.low;
  const double margin = std::ceil(kMargin * std::max(size.x, size.y) + path.style.stroke_width);
  for (Point& p : drawn.curve.points) p += Point{margin, margin} - box.low;
  drawn.lengths = cumulative_lengths(drawn.curve);

  const Example& own = style.example();
  SmoothCurve smooth = smooth_curve(drawn, length, fit_tolerances(own, 1));
  path.path = std::move(smooth.path);
  set_features(path.along, own.features(), smooth.features);
  Document document;
  document.header.name = example.header.name;
  document.header.width = std::ceil(size.x + 2 * margin);
  document.header.height = std::ceil(size.y + 2 * margin);
  document.records.emplace_back(std::move(path));
  return document;
}

}  // namespace libstyle
