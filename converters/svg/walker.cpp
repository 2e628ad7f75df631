// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/walker.h"

#include <algorithm>
#include <utility>

#include "converters/svg/cascade.h"
#include "converters/svg/conditions.h"
#include "converters/svg/element_path.h"

namespace libstyle::svg {
namespace {

// Elements within elements where `use` and markers count too: at most 3 MB of stack.
constexpr std::size_t kDepthLimit = 1200;

bool is_finite(const Path& path, const Transform& map) {
  return std::ranges::all_of(path.points(), [&](Point p) { return libstyle::is_finite(map(p)); });
}

bool is_within(pugi::xml_node element, pugi::xml_node ancestor) {
  while (element && element != ancestor) element = element.parent();
  return !element.empty();
}

Rectangle viewport_of(const Scope& scope) {
  const LengthContext context = length_context(scope.style, scope.viewport);
  constexpr Length kWhole = {100, LengthUnit::kPercent};
  return {resolve(scope.style.x, LengthAxis::kHorizontal, context),
          resolve(scope.style.y, LengthAxis::kVertical, context),
          resolve(scope.style.width.value_or(kWhole), LengthAxis::kHorizontal, context),
          resolve(scope.style.height.value_or(kWhole), LengthAxis::kVertical, context)};
}

}  // namespace

// --- Structure ----------------------------------------------------------------------------------

void Walker::draw_children(pugi::xml_node element, const Scope& scope) {
  for (const pugi::xml_node child : element.children()) {
    if (child.type() == pugi::node_element) draw(child, scope);
  }
}

void Walker::draw(pugi::xml_node element, const Scope& parent) {
  const ElementKind kind = element_kind(element.name());
  if (kind == ElementKind::kForeign || kind == ElementKind::kNeverDrawn ||
      kind == ElementKind::kActive) {
    return;
  }
  Scope scope = enter(element, parent);
  count_element(element, scope);
  switch (kind) {
    case ElementKind::kGroup:
      return draw_group(element, scope);
    case ElementKind::kSwitch:
      return draw_switch(element, scope);
    case ElementKind::kSvg:
      return draw_nested_svg(element, scope);
    case ElementKind::kUse:
      return draw_use(element, scope);
    case ElementKind::kNotCarried:
      return drawing_.reporter.warn(element, std::string(element.name()) + " is not carried");
    default:
      return draw_shape(element, kind, scope);
  }
}

Scope Walker::enter(pugi::xml_node element, const Scope& parent) const {
  Scope scope;
  scope.style = cascade(element, parent.style, drawing_.index.sheets());
  scope.page_from_user = parent.page_from_user;
  if (scope.style.transform) scope.page_from_user = scope.page_from_user * *scope.style.transform;
  scope.viewport = parent.viewport;
  scope.group = parent.group;
  scope.depth = parent.depth + 1;
  return scope;
}

void Walker::draw_group(pugi::xml_node element, Scope& scope) {
  if (!canvas_.open_group(element, scope, std::nullopt)) return;
  draw_children(element, scope);
}

void Walker::draw_switch(pugi::xml_node element, Scope& scope) {
  if (!canvas_.open_group(element, scope, std::nullopt)) return;
  for (const pugi::xml_node child : element.children()) {
    const bool drawable =
        child.type() == pugi::node_element && element_kind(child.name()) != ElementKind::kForeign;
    if (drawable && conditions_hold(child)) return draw(child, scope);
  }
}

void Walker::draw_nested_svg(pugi::xml_node element, Scope& scope) {
  const Rectangle viewport = viewport_of(scope);
  draw_viewport(element, scope, viewport);
}

// --- use ----------------------------------------------------------------------------------------

void Walker::draw_use(pugi::xml_node element, Scope& scope) {
  const pugi::xml_node target = drawing_.index.find_target(element);
  if (!target) {
    return drawing_.reporter.warn(
        element, "refers to \"" + std::string(link_of(element)) + "\", which is not in the file");
  }
  if (is_cycle(element, target))
    return drawing_.reporter.warn(element, "refers to itself; it is left out");
  if (!canvas_.open_group(element, scope, std::nullopt)) return;
  targets_.push_back(target);
  draw_target(target, element, scope);
  targets_.pop_back();
}

// What is drawn is moved to x and y, except that a symbol opens its viewport there. Width and
// height given here are those of the viewport that a symbol or svg opens (SVG 1.1, section 5.6).
void Walker::draw_target(pugi::xml_node target, pugi::xml_node use, Scope& scope) {
  const std::string_view name = target.name();
  const Rectangle viewport = viewport_of(scope);
  if (name != "symbol") {
    scope.page_from_user = scope.page_from_user * Transform::translation({viewport.x, viewport.y});
  }
  if (name != "symbol" && name != "svg") return draw(target, scope);
  Scope inner = enter(target, scope);
  count_element(use, inner);
  if (name == "symbol") return draw_viewport(target, inner, viewport);
  const Rectangle own = viewport_of(inner);
  draw_viewport(target, inner,
                {own.x, own.y, scope.style.width ? viewport.width : own.width,
                 scope.style.height ? viewport.height : own.height});
}

bool Walker::is_cycle(pugi::xml_node use, pugi::xml_node target) const {
  return is_within(use, target) || std::ranges::find(targets_, target) != targets_.end();
}

// --- Viewports and shapes -----------------------------------------------------------------------

void Walker::draw_viewport(pugi::xml_node element, Scope& scope, const Rectangle& viewport) {
  if (!(viewport.width > 0 && viewport.height > 0)) return;
  const auto view_box = parse_view_box(element.attribute("viewBox").value());
  std::optional<Transform> viewport_from_inside = Transform::translation({viewport.x, viewport.y});
  Vector inside = {viewport.width, viewport.height};
  if (view_box) {
    const auto ratio = parse_aspect_ratio(element.attribute("preserveAspectRatio").value());
    viewport_from_inside =
        viewport_from_view_box(viewport, *view_box, ratio.value_or(AspectRatio{}));
    inside = {view_box->width, view_box->height};
  }
  if (!viewport_from_inside) return;
  const bool clipped = scope.style.overflow == Overflow::kHidden;
  const auto clip = clipped ? std::optional(viewport) : std::nullopt;
  if (!canvas_.open_group(element, scope, clip)) return;
  scope.page_from_user = scope.page_from_user * *viewport_from_inside;
  scope.viewport = inside;
  draw_children(element, scope);
}

void Walker::draw_shape(pugi::xml_node element, ElementKind kind, const Scope& scope) {
  Path path = element_path(element, kind, scope.style, scope.viewport, drawing_.limits.points,
                           drawing_.reporter);
  if (path.empty()) return;
  count_points(element, path);
  if (!is_finite(path, scope.page_from_user)) {
    return drawing_.reporter.warn(element, "has coordinates that are too large; it is left out");
  }
  canvas_.draw_path(element, kind, std::move(path), scope);
}

// --- Limits -------------------------------------------------------------------------------------

void Walker::count_element(pugi::xml_node element, const Scope& scope) {
  if (scope.depth > kDepthLimit) {
    throw Error(drawing_.file.place(element),
                "use draws elements deeper than " + std::to_string(kDepthLimit) + " levels");
  }
  const bool counted = kind_ == WalkKind::kRepeated || !targets_.empty();
  if (!counted || ++drawing_.used_elements <= drawing_.limits.used_elements) return;
  throw Error(drawing_.file.place(element),
              "use draws more than " + std::to_string(drawing_.limits.used_elements) + " elements");
}

void Walker::count_points(pugi::xml_node element, const Path& path) {
  drawing_.points += path.points().size();
  if (drawing_.points <= drawing_.limits.points) return;
  throw Error(drawing_.file.place(element),
              "the paths have more than " + std::to_string(drawing_.limits.points) + " points");
}

}  // namespace libstyle::svg
