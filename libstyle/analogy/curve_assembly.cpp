// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/curve_assembly.h"

#include <utility>

#include "libstyle/geometry/arc_length.h"

namespace libstyle {

CurveAssembly::CurveAssembly(const Polyline& curve, std::size_t features) : closed_(curve.closed) {
  result_.curve.closed = curve.closed;
  result_.features.resize(features);
}

void CurveAssembly::append(DrawnPart drawn, const PlainLine& line, bool last) {
  result_.walks.push_back(std::move(drawn.walk));
  if (line.starts_at_corner) result_.corners.push_back(result_.curve.points.size());
  append_points(drawn.line, line.length_before, last);
  for (DrawnLine& stroke : drawn.strokes) {
    for (double& length : stroke.lengths) length += line.length_before;
    result_.strokes.push_back(std::move(stroke));
  }
  const std::size_t first =
      result_.runs.empty() ? 0 : result_.runs.back().first + result_.runs.back().steps;
  for (ChainRun& run : drawn.runs) {
    run.first += first;
    result_.runs.push_back(run);
  }
  length_ += arc_length(line.line);
  scaled_length_ += drawn.scaled_length;
}

StyledCurve CurveAssembly::take() {
  result_.mean_scale = scaled_length_ / length_;
  return std::move(result_);
}

// A line that another one follows leaves its last point to that one.
void CurveAssembly::append_points(const DrawnLine& line, double length_before, bool last) {
  const std::size_t begin = result_.curve.points.size(), end = line.curve.points.size();
  const bool joins = !line.curve.closed && (closed_ || !last);
  for (const std::size_t i : line.pinned) {
    const bool is_end = i == 0 || i + 1 == end;
    if (!is_end || line.curve.closed) result_.pinned.push_back(begin + i);
  }
  const std::size_t count = end - (joins ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    result_.curve.points.push_back(line.curve.points[i]);
    result_.lengths.push_back(length_before + line.lengths[i]);
  }
  for (std::size_t i = 0; i < result_.features.size(); ++i) {
    const auto own = line.features[i].begin();
    result_.features[i].insert(result_.features[i].end(), own,
                               own + static_cast<std::ptrdiff_t>(count));
  }
}

}  // namespace libstyle
