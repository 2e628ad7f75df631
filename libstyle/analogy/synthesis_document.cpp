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

Document synthesized_document(const CurveSynthesis& style, const SynthesizedCurve& made,
                              const Document& example) {
  StyledCurve drawn;
  drawn.curve = made.curve;
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

  path.path =
      smooth_curve(drawn, arc_length(made.curve), kFitTolerance * style.example().feature_size())
          .path;
  Document document;
  document.header.name = example.header.name;
  document.header.width = std::ceil(size.x + (before + margin));
  document.header.height = std::ceil(size.y + (before + margin));
  document.records.emplace_back(std::move(path));
  return document;
}

}  // namespace libstyle
