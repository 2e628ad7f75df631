// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/gradients.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "converters/svg/measured_box.h"
#include "converters/svg/pen_space.h"

namespace libstyle::svg {
namespace {

std::optional<Box> box_of(const PaintedShape& shape) {
  return shape.bounds ? shape.bounds : measured_box(shape.path, shape.page_from_user);
}

// Brings the unit square to a box.
Transform box_transform(const Box& box) {
  return {box.width(), 0, 0, box.height(), box.low.x, box.low.y};
}

// Lengths in user space, or as shares of the box.
class Resolver {
 public:
  Resolver(const GradientDefinition& definition, const LengthContext& context)
      : context_(definition.in_bounding_box ? LengthContext{1, 1, context.font_size} : context) {}

  Point point(Length x, Length y) const {
    return {resolve(x, LengthAxis::kHorizontal, context_),
            resolve(y, LengthAxis::kVertical, context_)};
  }
  // A negative radius is an error that librsvg draws as if it had no sign.
  double radius(Length length) const {
    return std::abs(resolve(length, LengthAxis::kDiagonal, context_));
  }

 private:
  LengthContext context_;
};

std::variant<LinearGeometry, RadialGeometry> resolve_geometry(const GradientDefinition& definition,
                                                              const LengthContext& context) {
  const Resolver resolver(definition, context);
  if (!definition.radial) {
    return LinearGeometry{resolver.point(definition.x1, definition.y1),
                          resolver.point(definition.x2, definition.y2)};
  }
  return RadialGeometry{resolver.point(definition.center_x, definition.center_y),
                        resolver.point(definition.focus_x, definition.focus_y),
                        resolver.radius(definition.radius),
                        resolver.radius(definition.focus_radius)};
}

std::array<double, 6> numbers_of(const LinearGeometry& g) {
  return {g.start.x, g.start.y, g.end.x, g.end.y, 0, 0};
}

std::array<double, 6> numbers_of(const RadialGeometry& g) {
  return {g.center.x, g.center.y, g.focus.x, g.focus.y, g.radius, g.focus_radius};
}

std::array<double, 12> numbers_of(const GradientRecord& record) {
  const Transform& t = record.page_from_gradient;
  const auto g = std::visit([](const auto& known) { return numbers_of(known); }, record.geometry);
  return {t.a, t.b, t.c, t.d, t.e, t.f, g[0], g[1], g[2], g[3], g[4], g[5]};
}

bool is_finite(const std::array<double, 12>& numbers) {
  for (const double number : numbers) {
    if (!std::isfinite(number)) return false;
  }
  return true;
}

// As Cairo sees it.
bool has_no_extent(const std::variant<LinearGeometry, RadialGeometry>& geometry) {
  constexpr double kLeast = std::numeric_limits<double>::epsilon();
  if (const auto* linear = std::get_if<LinearGeometry>(&geometry)) {
    return std::abs(linear->end.x - linear->start.x) < kLeast &&
           std::abs(linear->end.y - linear->start.y) < kLeast;
  }
  const auto& radial = std::get<RadialGeometry>(geometry);
  return std::abs(radial.radius - radial.focus_radius) < kLeast &&
         (std::min(radial.radius, radial.focus_radius) < kLeast || radial.center == radial.focus);
}

// How much of a colour the stops are on average, each by the way to its neighbours on both sides,
// over a repetition of the gradient; twice that.
std::vector<double> stop_weights(const std::vector<GradientStop>& stops, Spread spread) {
  const std::size_t last = stops.size() - 1;
  std::vector<double> weights(stops.size());
  if (spread == Spread::kPad || last == 0) {
    weights.front() += 1;
    weights.back() += 1;
    return weights;
  }
  const bool turns = spread == Spread::kReflect;
  for (std::size_t i = 0; i <= last; ++i) {
    const double before = i > 0   ? stops[i - 1].offset
                          : turns ? -stops[0].offset
                                  : stops[last].offset - 1;
    const double after = i < last ? stops[i + 1].offset
                         : turns  ? 2 - stops[last].offset
                                  : 1 + stops[0].offset;
    weights[i] = after - before;
  }
  return weights;
}

// SVG wants the last colour here. librsvg leaves it to Cairo, which paints the mean of the first
// and the last or, where the gradient repeats, of all; nothing for a radial gradient.
Paint paint_without_extent(const GradientDefinition& definition, double& opacity) {
  if (definition.radial) return NoPaint{};
  const std::vector<double> weights = stop_weights(definition.stops, definition.spread);
  std::array<double, 3> sums{};
  double alpha = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const GradientStop& stop = definition.stops[i];
    sums[0] += weights[i] * stop.color.red;
    sums[1] += weights[i] * stop.color.green;
    sums[2] += weights[i] * stop.color.blue;
    alpha += weights[i] / 2 * stop.opacity;
  }
  const auto channel = [&](std::size_t i) {
    return static_cast<std::uint8_t>(std::floor(sums[i] / 2 + 0.5));
  };
  opacity *= alpha;
  return Color{channel(0), channel(1), channel(2)};
}

}  // namespace

std::optional<Paint> Gradients::paint(pugi::xml_node element, const PaintedShape& shape,
                                      double& opacity) {
  const std::optional<GradientDefinition>& definition = this->definition(element);
  if (!definition) return std::nullopt;
  Transform page_from_units = shape.page_from_user;
  if (definition->in_bounding_box) {
    const std::optional<Box> box = box_of(shape);
    if (!box || !(box->width() > 0 && box->height() > 0)) return std::nullopt;
    page_from_units = page_from_units * box_transform(*box);
  }
  GradientRecord record;
  record.page_from_gradient =
      to_page(definition->transform, page_from_units, definition->carried_transform);
  record.geometry = resolve_geometry(*definition, shape.context);
  if (!is_finite(numbers_of(record)) || !inverse(record.page_from_gradient)) return std::nullopt;
  if (definition->stops.empty()) return NoPaint{};
  if (has_no_extent(record.geometry)) return paint_without_extent(*definition, opacity);
  record.spread = definition->spread;
  record.stops = definition->stops;
  return PaintReference{record_id(element, std::move(record))};
}

const std::optional<GradientDefinition>& Gradients::definition(pugi::xml_node element) {
  const auto found = definitions_.find(element.internal_object());
  if (found != definitions_.end()) return found->second;
  return definitions_.emplace(element.internal_object(), read_gradient(element, index_, reporter_))
      .first->second;
}

std::string Gradients::record_id(pugi::xml_node element, GradientRecord record) {
  std::string& id = ids_[{element.internal_object(), numbers_of(record)}];
  if (id.empty()) id = builder_.add_gradient(element, std::move(record));
  return id;
}

}  // namespace libstyle::svg
