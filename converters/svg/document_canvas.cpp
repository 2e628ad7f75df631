// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/document_canvas.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "converters/svg/bounds_canvas.h"
#include "converters/svg/carried_keys.h"
#include "converters/svg/element_path.h"
#include "converters/svg/measured_box.h"
#include "converters/svg/pen_space.h"
#include "converters/svg/shape_element.h"
#include "converters/svg/shapes.h"

namespace libstyle::svg {
namespace {

std::string_view shape_name(ElementKind kind, pugi::xml_node element) {
  if (kind == ElementKind::kText) return "text";
  return kind == ElementKind::kPath ? std::string_view() : element.name();
}

bool is_outermost(pugi::xml_node element) { return element.parent().type() == pugi::node_document; }

bool is_plain(const GroupLook& look) {
  return look.opacity == 1 && look.blend_mode == BlendMode::kNormal && !look.hidden;
}

// Whether a group is there only to clip a path that is in a space of its own (svg_writer.cpp), and
// nobody has made more of it since.
bool is_for_its_path(pugi::xml_node group) {
  if (std::string_view(group.attribute(kCarriedFor).value()) != "path") return false;
  const auto is_clip = [](pugi::xml_attribute attribute) {
    const std::string_view name = attribute.name();
    return name == kCarriedFor || name == "clip-path";
  };
  const auto is_path_or_definition = [](pugi::xml_node child) {
    const std::string_view name = child.name();
    return child.type() != pugi::node_element || name == "path" || name == "defs";
  };
  const auto paths = group.children("path");
  return std::ranges::all_of(group.attributes(), is_clip) &&
         std::ranges::all_of(group.children(), is_path_or_definition) &&
         std::distance(paths.begin(), paths.end()) == 1;
}

}  // namespace

// The outermost element is the document itself; it is a group only where it is drawn as one.
bool DocumentCanvas::open_group(pugi::xml_node element, Scope& scope,
                                const std::optional<Rectangle>& viewport) {
  warn_not_carried(element, scope.style);
  GroupLook look;
  look.opacity = scope.style.opacity;
  look.blend_mode = scope.style.blend_mode;
  look.isolated = scope.style.isolated;
  look.hidden = scope.style.display == Display::kNone;
  look.clip = clips_.find_or_add(element, scope, [&] {
    return scope.bounds ? *scope.bounds : measure_members(drawing_, element, scope);
  });
  // A viewport within a clip is a group of its own: librsvg knows no clips on clips.
  const bool twice = viewport && !look.clip.empty();
  if (viewport && !twice) look.clip = add_viewport_clip(*viewport, scope);
  if (is_plain(look) && !look.isolated && is_for_its_path(element)) {
    scope.path_clip = look.clip;
    return true;
  }
  const bool says_nothing = is_plain(look) && look.clip.empty();
  if (!says_nothing || !is_outermost(element)) {
    scope.group = builder_.add_group(element, look, scope.group);
  }
  if (twice) {
    GroupLook inside;
    inside.clip = add_viewport_clip(*viewport, scope);
    scope.group = builder_.add_group({}, inside, scope.group);
  }
  return true;
}

std::string DocumentCanvas::add_viewport_clip(const Rectangle& viewport, const Scope& scope) {
  ClipPart part;
  part.path = rectangle_path(viewport, std::nullopt, std::nullopt);
  part.path.transform(scope.page_from_user);
  const bool finite = std::ranges::all_of(part.path.points(), [](Point p) { return is_finite(p); });
  return finite ? builder_.add_clip({}, {std::move(part)}, {}) : std::string();
}

void DocumentCanvas::draw_path(pugi::xml_node element, ElementKind kind, Path path,
                               const Scope& scope) {
  warn_not_carried(element, scope.style);
  PathRecord record;
  record.clip = clips_.find_or_add(element, scope, [&] {
    return scope.bounds ? *scope.bounds : measured_box(path, scope.page_from_user).value_or(Box{});
  });
  const LengthContext context = length_context(scope.style, scope.viewport);
  record.style = painter_.painted_style(element, scope.style, scope.paint_context,
                                        {path, scope.bounds, scope.page_from_user, context});
  const bool marked = markers_.any(kind, scope.style);
  const Path user_path = marked ? path : Path();
  record.path =
      to_page(std::move(path), scope.page_from_user, element.attribute(kCarriedPath).value());
  record.shape = shape_name(kind, element);
  settle_shape(record.shape, record.path);
  const std::string group = group_around(record, scope, marked);
  if (!marked) return builder_.add_path(element, std::move(record), group);
  Scope around = scope;
  around.group = group;
  const auto draw_markers = [&] { markers_.draw(element, kind, user_path, around); };
  add_path_and_markers(element, std::move(record), around, draw_markers);
}

// A path that has its markers between fill and stroke becomes two.
void DocumentCanvas::add_path_and_markers(pugi::xml_node element, PathRecord record,
                                          const Scope& scope,
                                          const std::function<void()>& draw_markers) {
  const PaintOrder& order = scope.style.paint_order;
  const bool after_fill = order.comes_before(PaintPart::kFill, PaintPart::kMarkers);
  const bool after_stroke = order.comes_before(PaintPart::kStroke, PaintPart::kMarkers);
  if (!after_fill && !after_stroke) draw_markers();
  if (after_fill == after_stroke) {
    builder_.add_path(element, std::move(record), scope.group);
  } else {
    PathRecord upper = record;
    (after_fill ? record : upper).style.stroke.reset();
    (after_fill ? upper : record).style.fill = NoPaint{};
    builder_.add_path(element, std::move(record), scope.group);
    draw_markers();
    builder_.add_path(element, std::move(upper), scope.group);
  }
  if (after_fill && after_stroke) draw_markers();
}

// A clip that the path takes over stands around its own. Opacity and clip of a path are also those
// of its markers: a group takes them over. Only groups have blend modes.
std::string DocumentCanvas::group_around(PathRecord& path, const Scope& scope, bool marked) {
  std::string outer = scope.group;
  if (path.clip.empty()) {
    path.clip = scope.path_clip;
  } else {
    outer = builder_.add_group({}, {.clip = scope.path_clip}, outer);
  }
  GroupLook look;
  look.blend_mode = scope.style.blend_mode;
  if (marked) {
    look.opacity = std::exchange(path.style.opacity, 1);
    look.clip = std::exchange(path.clip, "");
  }
  return builder_.add_group({}, look, outer);
}

void DocumentCanvas::warn_not_carried(pugi::xml_node element, const ComputedStyle& style) {
  const auto warn = [&](std::string_view value, const std::string& what) {
    if (!value.empty()) drawing_.reporter.warn(element, what + " is not carried");
  };
  warn(style.mask, "mask");
  warn(style.filter, "filter");
}

}  // namespace libstyle::svg
