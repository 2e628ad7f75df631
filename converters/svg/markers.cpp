// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/markers.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "converters/svg/angle.h"
#include "converters/svg/cascade.h"
#include "converters/svg/element_path.h"
#include "converters/svg/path_grammar.h"
#include "converters/svg/scanner.h"
#include "converters/svg/view_box.h"

namespace libstyle::svg {
namespace {

// What the attributes of a marker say. As librsvg has it, one that is wrong ends their reading; the
// rest keep their initial values, and the marker is drawn.
struct MarkerAttributes {
  Length width = {3}, height = {3};
  Length reference_x, reference_y;
  std::optional<Rectangle> view_box;
  AspectRatio ratio;
  bool scaled_by_stroke = true;
  std::string_view orient;
};

template <typename Target, typename Value>
bool assign(Target& target, const std::optional<Value>& value) {
  if (value) target = *value;
  return value.has_value();
}

bool assign_size(Length& target, const std::optional<Length>& size) {
  return assign(target, size) && size->value >= 0;
}

bool read_units(std::string_view text, bool& scaled_by_stroke) {
  scaled_by_stroke = equal_ignoring_case(text, "strokeWidth");
  return scaled_by_stroke || equal_ignoring_case(text, "userSpaceOnUse");
}

bool read_attribute(std::string_view name, std::string_view value, MarkerAttributes& marker) {
  if (name == "markerWidth") return assign_size(marker.width, parse_leading_length(value));
  if (name == "markerHeight") return assign_size(marker.height, parse_leading_length(value));
  if (name == "refX") return assign(marker.reference_x, parse_leading_length(value));
  if (name == "refY") return assign(marker.reference_y, parse_leading_length(value));
  if (name == "viewBox") return assign(marker.view_box, parse_view_box(value));
  if (name == "preserveAspectRatio") return assign(marker.ratio, parse_aspect_ratio(value));
  if (name == "markerUnits") return read_units(value, marker.scaled_by_stroke);
  if (name == "orient") marker.orient = trimmed(value);
  return true;
}

MarkerAttributes read_attributes(pugi::xml_node marker) {
  MarkerAttributes result;
  for (const pugi::xml_attribute attribute : marker.attributes()) {
    MarkerAttributes next = result;
    if (!read_attribute(attribute.name(), attribute.value(), next)) break;
    result = next;
  }
  return result;
}

// The space of a marker.
struct MarkerSpace {
  Rectangle inside;  // its viewport, or viewBox, in the units inside
  Transform viewport_from_inside;
  Point reference;  // what is put on the vertex, in the viewport
};

// Nothing where nothing would be seen: a size of 0.
std::optional<MarkerSpace> make_space(const MarkerAttributes& marker, const ComputedStyle& style,
                                      const Vector& viewport) {
  const LengthContext outside = length_context(style, viewport);
  MarkerSpace space;
  space.inside.width = resolve(marker.width, LengthAxis::kHorizontal, outside);
  space.inside.height = resolve(marker.height, LengthAxis::kVertical, outside);
  if (!(space.inside.width > 0 && space.inside.height > 0)) return std::nullopt;
  if (marker.view_box) {
    const auto map = viewport_from_view_box(space.inside, *marker.view_box, marker.ratio);
    if (!map) return std::nullopt;
    space.viewport_from_inside = *map;
    space.inside = *marker.view_box;
  }
  const LengthContext inside = length_context(style, {space.inside.width, space.inside.height});
  space.reference =
      space.viewport_from_inside({resolve(marker.reference_x, LengthAxis::kHorizontal, inside),
                                  resolve(marker.reference_y, LengthAxis::kVertical, inside)});
  return space;
}

// The direction that the marker's x axis gets.
Vector orientation(std::string_view text, const MarkerVertex& vertex) {
  if (equal_ignoring_case(text, "auto")) return vertex.direction;
  if (equal_ignoring_case(text, "auto-start-reverse")) {
    return vertex.place == MarkerPlace::kStart ? -vertex.direction : vertex.direction;
  }
  Scanner scanner(text);
  double angle = 0;
  if (!scanner.take_css_number(angle)) return {1, 0};
  const std::string_view unit = scanner.take_word();
  const std::optional<double> degrees = unit.empty() ? 1 : degrees_per_svg_unit(unit);
  return scanner.at_end() && degrees ? unit_vector_at(angle * *degrees) : Vector{1, 0};
}

double marker_scale(const MarkerAttributes& marker, const Scope& scope) {
  if (!marker.scaled_by_stroke) return 1;
  return resolve(scope.style.stroke_width, LengthAxis::kDiagonal,
                 length_context(scope.style, scope.viewport));
}

}  // namespace

bool Markers::any(ElementKind kind, const ComputedStyle& style) const {
  const bool takes_markers = kind == ElementKind::kPath || kind == ElementKind::kLine ||
                             kind == ElementKind::kPolyline || kind == ElementKind::kPolygon;
  return takes_markers &&
         (marker_for(MarkerPlace::kStart, style) || marker_for(MarkerPlace::kMid, style) ||
          marker_for(MarkerPlace::kEnd, style));
}

void Markers::draw(pugi::xml_node element, ElementKind kind, const Path& path, const Scope& scope) {
  const bool is_path = kind == ElementKind::kPath;
  const Path vertices = is_path ? parse_path_vertices(element.attribute("d").value()) : path;
  for (const MarkerVertex& vertex : marker_vertices(vertices)) {
    const pugi::xml_node marker = marker_for(vertex.place, scope.style);
    if (marker) draw_one(marker, vertex, scope);
  }
}

// Null also for a marker within itself.
pugi::xml_node Markers::marker_for(MarkerPlace place, const ComputedStyle& style) const {
  const std::string_view reference = place == MarkerPlace::kStart ? style.marker_start
                                     : place == MarkerPlace::kMid ? style.marker_mid
                                                                  : style.marker_end;
  const pugi::xml_node marker = drawing_.index.find_reference(reference);
  const bool usable = std::string_view(marker.name()) == "marker" &&
                      std::ranges::find(open_, marker) == open_.end();
  return usable ? marker : pugi::xml_node();
}

void Markers::draw_one(pugi::xml_node marker, const MarkerVertex& vertex, const Scope& scope) {
  count_used(drawing_, marker);
  Scope inside;
  inside.style = style_in_place(marker, drawing_.index.sheets());
  const MarkerAttributes attributes = read_attributes(marker);
  const std::optional<MarkerSpace> space = make_space(attributes, inside.style, scope.viewport);
  if (!space) return;
  const Vector x = marker_scale(attributes, scope) * orientation(attributes.orient, vertex);
  const Transform user_from_marker = {x.x, x.y, -x.y, x.x, vertex.position.x, vertex.position.y};
  inside.page_from_user = scope.page_from_user * user_from_marker *
                          Transform::translation(-space->reference) * space->viewport_from_inside;
  if (!inside.page_from_user.is_finite() || inside.page_from_user.determinant() == 0) return;

  const bool hidden =
      scope.style.display == Display::kNone || scope.style.visibility == Visibility::kHidden;
  inside.style.display = hidden ? Display::kNone : Display::kInline;  // its own has no say
  inside.paint_context = paints_of(scope.style, scope.paint_context);
  inside.viewport = {space->inside.width, space->inside.height};
  inside.group = scope.group;
  inside.depth = scope.depth + 1;
  const bool clipped = inside.style.overflow == Overflow::kHidden;
  open_.push_back(marker);
  if (canvas_.open_group(marker, inside, clipped ? std::optional(space->inside) : std::nullopt)) {
    Walker(drawing_, canvas_, WalkKind::kRepeated).draw_children(marker, inside);
  }
  open_.pop_back();
}

}  // namespace libstyle::svg
