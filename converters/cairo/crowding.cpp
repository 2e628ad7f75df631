// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/crowding.h"

#include <algorithm>
#include <cmath>

namespace libstyle {
namespace {

// How many segments cross each row, as the differences from row to row.
class Rows {
 public:
  explicit Rows(const Box& window)
      : top_(window.low.y),
        last_(std::max(0.0, std::ceil(window.high.y - window.low.y) - 1)),
        steps_(static_cast<std::size_t>(last_) + 2) {}

  void add(Point from, Point to) {
    const double first = std::floor(std::min(from.y, to.y) - top_);
    const double last = std::floor(std::max(from.y, to.y) - top_);
    if (!(last >= 0 && first <= last_)) return;
    ++steps_[static_cast<std::size_t>(std::max(first, 0.0))];
    --steps_[static_cast<std::size_t>(std::min(last, last_)) + 1];
  }

  double sum_of_squares() const {
    double sum = 0, count = 0;
    for (const std::int64_t step : steps_) {
      count += static_cast<double>(step);
      sum += count * count;
    }
    return sum;
  }

 private:
  double top_, last_;  // the first row begins at top_; the index of the last
  std::vector<std::int64_t> steps_;
};

}  // namespace

double edge_pairs(const Path& path, const Transform& device_from_path, const Box& window) {
  Rows rows(window);
  const Point* next = path.points().data();
  Point start, at;
  for (const PathCommand command : path.commands()) {
    if (command == PathCommand::kClose) rows.add(at, start);
    for (const Point* const end = next + point_count(command); next != end; ++next) {
      const Point to = device_from_path(*next);
      if (command == PathCommand::kMove) {
        start = to;
      } else {
        rows.add(at, to);
      }
      at = to;
    }
  }
  return rows.sum_of_squares();
}

void count_edges(Canvas& canvas, const Path& path, const Transform& device_from_path,
                 double edges_per_segment) {
  constexpr std::size_t kFew = 100;  // points; nothing on a page of any size
  if (!canvas.is_raster || path.points().size() <= kFew) return;
  canvas.edge_pairs +=
      edges_per_segment * edges_per_segment * edge_pairs(path, device_from_path, canvas.window);
  if (canvas.edge_pairs > kMostEdgePairs) {
    throw Error(
        "so many lines side by side would take minutes to draw as PNG; simplify the path, or draw "
        "it as SVG or PDF");
  }
}

}  // namespace libstyle
