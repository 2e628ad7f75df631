// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/gradients.h"

#include <cmath>

#include "converters/svg/pen_space.h"
#include "libstyle/geometry/path_segments.h"

namespace libstyle::svg {
namespace {

bool keeps_axes(const Transform& map) {
  return (map.b == 0 && map.c == 0) || (map.a == 0 && map.d == 0);
}

Box box_of(const PaintedShape& shape) {
  return shape.bounds ? *shape.bounds : bounding_box(shape.path);
}

// The box of a shape in its user space. Of one that is turned or skewed it is the box around that
// on the page, brought back, and so too large: librsvg measures shapes so, and gradients show it.
// (Parts of a text have the box of the text.)
std::optional<Box> measured_box(const PaintedShape& shape) {
  if (shape.bounds || keeps_axes(shape.page_from_user)) return box_of(shape);
  const std::optional<Transform> user_from_page = inverse(shape.page_from_user);
  if (!user_from_page) return std::nullopt;
  Path on_page = shape.path;
  on_page.transform(shape.page_from_user);
  const Box page_box = bounding_box(on_page);
  Box box;
  for (const double x : {page_box.low.x, page_box.high.x}) {
    for (const double y : {page_box.low.y, page_box.high.y}) {
      box.include((*user_from_page)(Point{x, y}));
    }
  }
  return box;
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

}  // namespace

std::optional<Paint> Gradients::paint(pugi::xml_node element, const PaintedShape& shape) {
  const std::optional<GradientDefinition>& definition = this->definition(element);
  if (!definition) return std::nullopt;
  Transform page_from_units = shape.page_from_user;
  if (definition->in_bounding_box) {
    const Box own = box_of(shape);
    if (!(own.width() > 0 && own.height() > 0)) return std::nullopt;
    const std::optional<Box> box = measured_box(shape);
    if (!box) return std::nullopt;
    page_from_units = page_from_units * box_transform(*box);
  }
  GradientRecord record;
  record.page_from_gradient =
      to_page(definition->transform, page_from_units, definition->carried_transform);
  record.geometry = resolve_geometry(*definition, shape.context);
  if (!is_finite(numbers_of(record)) || !inverse(record.page_from_gradient)) return std::nullopt;
  if (definition->stops.empty()) return NoPaint{};
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
