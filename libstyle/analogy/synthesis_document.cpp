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

constexpr double kFitTolerance = 0.01;  // of a feature size, as for lines drawn again
constexpr double kMargin = 0.02;        // of the longer side

}  // namespace

std::vector<Polyline> synthesis_examples(std::span<const ExamplePair> pairs) {
  std::vector<Polyline> curves;
  for (const ExamplePair& pair : pairs) curves.push_back(pair.filtered.polyline);
  return curves;
}

Document synthesized_document(const CurveSynthesis& style, const Polyline& curve,
                              const Document& example) {
  StyledCurve drawn;
  drawn.curve = curve;
  Box box;
  for (const Point p : drawn.curve.points) box.include(p);
  PathRecord path = painted_like(example);
  const Vector size = box.high - box.low;
  const double margin = std::ceil(kMargin * std::max(size.x, size.y) + path.style.stroke_width);
  for (Point& p : drawn.curve.points) p += Point{margin, margin} - box.low;
  drawn.lengths = cumulative_lengths(drawn.curve);

  path.path =
      smooth_curve(drawn, arc_length(curve), kFitTolerance * style.example().feature_size()).path;
  Document document;
  document.header.name = example.header.name;
  document.header.width = std::ceil(size.x + 2 * margin);
  document.header.height = std::ceil(size.y + 2 * margin);
  document.records.emplace_back(std::move(path));
  return document;
}

}  // namespace libstyle
