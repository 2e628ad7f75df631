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

// What a marker element says of its own space.
struct MarkerSpace {
  Rectangle inside;  // its viewport, or viewBox, in the units inside
  Transform viewport_from_inside;
  Point reference;  // what is put on the vertex, in the viewport
};

double length(pugi::xml_node marker, const char* name, LengthAxis axis, double fallback,
              const LengthContext& context) {
  const std::optional<Length> value = parse_length(marker.attribute(name).value());
  return value ? resolve(*value, axis, context) : fallback;
}

// Nothing where nothing would be seen: a size of 0.
std::optional<MarkerSpace> read_space(pugi::xml_node marker, const ComputedStyle& style,
                                      const Vector& viewport) {
  const LengthContext outside = length_context(style, viewport);
  MarkerSpace space;
  space.inside.width = length(marker, "markerWidth", LengthAxis::kHorizontal, 3, outside);
  space.inside.height = length(marker, "markerHeight", LengthAxis::kVertical, 3, outside);
  if (!(space.inside.width > 0 && space.inside.height > 0)) return std::nullopt;
  if (const auto view_box = parse_view_box(marker.attribute("viewBox").value())) {
    const auto ratio = parse_aspect_ratio(marker.attribute("preserveAspectRatio").value());
    const auto map = viewport_from_view_box(space.inside, *view_box, ratio.value_or(AspectRatio{}));
    if (!map) return std::nullopt;
    space.viewport_from_inside = *map;
    space.inside = *view_box;
  }
  const LengthContext inside = length_context(style, {space.inside.width, space.inside.height});
  space.reference =
      space.viewport_from_inside({length(marker, "refX", LengthAxis::kHorizontal, 0, inside),
                                  length(marker, "refY", LengthAxis::kVertical, 0, inside)});
  return space;
}

// The direction that the marker's x axis gets.
Vector orientation(pugi::xml_node marker, const MarkerVertex& vertex) {
  const std::string_view text = trimmed(marker.attribute("orient").value());
  if (text == "auto") return vertex.direction;
  if (text == "auto-start-reverse") {
    return vertex.place == MarkerPlace::kStart ? -vertex.direction : vertex.direction;
  }
  Scanner scanner(text);
  double angle = 0;
  if (!scanner.take_number(angle)) return {1, 0};
  const std::string_view unit = scanner.take_word();
  const std::optional<double> degrees = unit.empty() ? 1 : degrees_per_unit(unit);
  return scanner.at_end() && degrees ? unit_vector_at(angle * *degrees) : Vector{1, 0};
}

double marker_scale(pugi::xml_node marker, const Scope& scope) {
  if (std::string_view(marker.attribute("markerUnits").value()) == "userSpaceOnUse") return 1;
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
  Scope inside;
  inside.style = style_in_place(marker, drawing_.index.sheets());
  const std::optional<MarkerSpace> space = read_space(marker, inside.style, scope.viewport);
  if (!space) return;
  const Vector x = marker_scale(marker, scope) * orientation(marker, vertex);
  const Transform user_from_marker = {x.x, x.y, -x.y, x.x, vertex.position.x, vertex.position.y};
  inside.page_from_user = scope.page_from_user * user_from_marker *
                          Transform::translation(-space->reference) * space->viewport_from_inside;
  if (!inside.page_from_user.is_finite() || inside.page_from_user.determinant() == 0) return;

  const bool hidden =
      scope.style.display == Display::kNone || scope.style.visibility == Visibility::kHidden;
  inside.style.display = hidden ? Display::kNone : Display::kInline;  // its own has no say
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
