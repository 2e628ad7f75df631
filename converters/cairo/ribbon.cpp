// SPDX-License-Identifier: Apache-2.0
#include "converters/cairo/ribbon.h"

#include <algorithm>
#include <cmath>

#include "converters/cairo/safe_path.h"
#include "libstyle/geometry/bezier.h"
#include "libstyle/geometry/flatten.h"

namespace libstyle {
namespace {

constexpr double kFlatness = 0.05;  // px, of the curve and of its offset
constexpr int kMostSteps = 1000;    // a segment

double angle_between(Vector a, Vector b) { return std::abs(std::atan2(cross(a, b), dot(a, b))); }

// Enough equal steps of the parameter for the curve, and for its offset by `radius`: a step that
// turns by 2a leaves the offset at most radius * (1 - cos(a)) flat.
int step_count(const CubicBezier& curve, double radius) {
  const Vector legs[] = {curve.p1 - curve.p0, curve.p2 - curve.p1, curve.p3 - curve.p2};
  const double turn = angle_between(legs[0], legs[1]) + angle_between(legs[1], legs[2]);
  const double half_step = std::acos(std::max(0.0, 1 - kFlatness / std::max(radius, kFlatness)));
  const double steps = std::max(flattening_steps(curve, kFlatness), turn / (2 * half_step));
  return static_cast<int>(std::clamp(std::ceil(steps), 1.0, double{kMostSteps}));
}

// The values of the vertices, one after another.
class VertexValues {
 public:
  VertexValues(const PathRecord& record, double scale) : record_(record), scale_(scale) {
    widths_ = record.along.find("width");
  }

  RibbonPoint next(Point place) {
    const std::size_t i = next_++;
    const double width = widths_ ? (*widths_)[i] : record_.style.stroke_width;
    RibbonPoint point{place, std::clamp(width * scale_ / 2, 0.0, kMostReach), {}};
    if (!record_.along.colors.empty()) {
      const Color color = record_.along.colors[i];
      point.color = {color.red / 255.0, color.green / 255.0, color.blue / 255.0,
                     color.alpha / 255.0};
    }
    return point;
  }

 private:
  const PathRecord& record_;
  double scale_;
  const std::vector<double>* widths_;
  std::size_t next_ = 0;
};

void append_cubic(const CubicBezier& curve, const RibbonPoint& from, const RibbonPoint& to,
                  Ribbon& ribbon) {
  if (ribbon.points.size() == 1) ribbon.start_tangent = tangent_at(curve, 0);
  ribbon.end_tangent = tangent_at(curve, 1);
  const int steps = step_count(curve, std::max(from.radius, to.radius));
  std::vector<Point> places(static_cast<std::size_t>(steps) + 1);
  std::vector<double> lengths(places.size(), 0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = point_at(curve, static_cast<double>(i) / steps);
    if (i > 0) lengths[i] = lengths[i - 1] + distance(places[i - 1], places[i]);
  }
  for (std::size_t i = 1; i < places.size(); ++i) {
    ribbon.points.push_back(lerp(from, to, lengths.back() > 0 ? lengths[i] / lengths.back() : 1));
    ribbon.points.back().place = places[i];
  }
}

// Leaves one of neighbours at one place: the widest, so that a dot keeps its size.
void join_neighbours(Ribbon& ribbon) {
  std::vector<RibbonPoint> kept;
  for (const RibbonPoint& point : ribbon.points) {
    if (kept.empty() || distance(kept.back().place, point.place) > 1e-6) {
      kept.push_back(point);
    } else if (point.radius > kept.back().radius) {
      kept.back() = point;
    }
  }
  if (ribbon.closed && kept.size() > 1 && distance(kept.back().place, kept.front().place) <= 1e-6) {
    kept.pop_back();
  }
  ribbon.points = std::move(kept);
}

}  // namespace

RibbonPoint lerp(const RibbonPoint& a, const RibbonPoint& b, double t) {
  RibbonPoint result{libstyle::lerp(a.place, b.place, t), a.radius + t * (b.radius - a.radius), {}};
  for (std::size_t i = 0; i < 4; ++i) result.color[i] = a.color[i] + t * (b.color[i] - a.color[i]);
  return result;
}

std::vector<Ribbon> make_ribbons(const PathRecord& record, const Transform& device_from_page) {
  std::vector<Ribbon> ribbons;
  VertexValues values(record, std::sqrt(std::abs(device_from_page.determinant())));
  const Point* next = record.path.points().data();
  RibbonPoint current;
  for (const PathCommand command : record.path.commands()) {
    const auto place = [&](std::size_t i) { return bounded(device_from_page(next[i])); };
    const RibbonPoint from = current;
    switch (command) {
      case PathCommand::kMove:
        ribbons.emplace_back();
        current = values.next(place(0));
        ribbons.back().points.push_back(current);
        break;
      case PathCommand::kLine:
        current = values.next(place(0));
        ribbons.back().points.push_back(current);
        ribbons.back().end_tangent = {};
        break;
      case PathCommand::kCubic:
        current = values.next(place(2));
        append_cubic({from.place, place(0), place(1), current.place}, from, current,
                     ribbons.back());
        break;
      case PathCommand::kClose:
        ribbons.back().closed = true;
        break;
    }
    next += point_count(command);
  }
  for (Ribbon& ribbon : ribbons) join_neighbours(ribbon);
  return ribbons;
}

}  // namespace libstyle
