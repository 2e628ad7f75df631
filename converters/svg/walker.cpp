// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/walker.h"

#include <algorithm>
#include <utility>

#include "converters/svg/cascade.h"
#include "converters/svg/conditions.h"
#include "converters/svg/element_path.h"
#include "converters/svg/page.h"
#include "converters/svg/shape_element.h"
#include "converters/svg/shapes.h"

namespace libstyle::svg {
namespace {

// Elements within elements where `use` counts too; the tree itself has a limit of its own.
constexpr std::size_t kDepthLimit = 2000;

bool is_finite(const Path& path) {
  return std::ranges::all_of(path.points(), [](Point p) { return libstyle::is_finite(p); });
}

std::string_view shape_name(ElementKind kind, pugi::xml_node element) {
  return kind == ElementKind::kPath ? std::string_view() : element.name();
}

bool is_within(pugi::xml_node element, pugi::xml_node ancestor) {
  while (element && element != ancestor) element = element.parent();
  return !element.empty();
}

}  // namespace

Walker::Walker(const XmlFile& file, const FileIndex& index, const SvgLimits& limits,
               Reporter& reporter, Document& document)
    : file_(file),
      index_(index),
      limits_(limits),
      reporter_(reporter),
      document_(document),
      builder_(file, reporter, document),
      painter_(index, reporter, builder_) {}

// --- Structure ----------------------------------------------------------------------------------

void Walker::walk() {
  const pugi::xml_node root = file_.root();
  Scope scope;
  scope.style = cascade(root, {}, index_.sheets());
  const Page page = read_page(root, scope.style);
  document_.header.width = page.width;
  document_.header.height = page.height;
  document_.header.page_width = page.width_text;
  document_.header.page_height = page.height_text;
  if (!page.page_from_user) return;
  scope.page_from_user = *page.page_from_user;
  if (scope.style.transform) scope.page_from_user = scope.page_from_user * *scope.style.transform;
  scope.viewport = page.viewport;
  open_root(root, scope);
  draw_children(root, scope);
  builder_.add_carried_records(root);
}

// The outermost element is the document itself; it is a group only where it is drawn as one.
void Walker::open_root(pugi::xml_node root, Scope& scope) {
  warn_not_carried(root, scope.style);
  if (scope.style.opacity != 1 || scope.style.display == Display::kNone) open_group(root, scope);
}

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
      return reporter_.warn(element, std::string(element.name()) + " is not carried");
    default:
      return draw_shape(element, kind, scope);
  }
}

Walker::Scope Walker::enter(pugi::xml_node element, const Scope& parent) const {
  Scope scope;
  scope.style = cascade(element, parent.style, index_.sheets());
  scope.page_from_user = parent.page_from_user;
  if (scope.style.transform) scope.page_from_user = scope.page_from_user * *scope.style.transform;
  scope.viewport = parent.viewport;
  scope.group = parent.group;
  scope.depth = parent.depth + 1;
  return scope;
}

void Walker::draw_group(pugi::xml_node element, Scope& scope) {
  open_group(element, scope);
  draw_children(element, scope);
}

void Walker::draw_switch(pugi::xml_node element, Scope& scope) {
  open_group(element, scope);
  for (const pugi::xml_node child : element.children()) {
    const bool drawable =
        child.type() == pugi::node_element && element_kind(child.name()) != ElementKind::kForeign;
    if (drawable && conditions_hold(child)) return draw(child, scope);
  }
}

void Walker::draw_nested_svg(pugi::xml_node element, Scope& scope) {
  const Rectangle viewport = viewport_of(scope.style, scope);
  draw_viewport(element, scope, viewport);
}

// --- use ----------------------------------------------------------------------------------------

void Walker::draw_use(pugi::xml_node element, Scope& scope) {
  const pugi::xml_node target = index_.find_target(element);
  if (!target) {
    return reporter_.warn(
        element, "refers to \"" + std::string(link_of(element)) + "\", which is not in the file");
  }
  if (is_cycle(element, target)) return reporter_.warn(element, "refers to itself; it is left out");
  open_group(element, scope);
  targets_.push_back(target);
  draw_target(target, element, scope);
  targets_.pop_back();
}

// What is drawn is moved to x and y, except that a symbol opens its viewport there. Width and
// height given here are those of the viewport that a symbol or svg opens (SVG 1.1, section 5.6).
void Walker::draw_target(pugi::xml_node target, pugi::xml_node use, Scope& scope) {
  const std::string_view name = target.name();
  const Rectangle viewport = viewport_of(scope.style, scope);
  if (name != "symbol") {
    scope.page_from_user = scope.page_from_user * Transform::translation({viewport.x, viewport.y});
  }
  if (name != "symbol" && name != "svg") return draw(target, scope);
  Scope inner = enter(target, scope);
  count_element(use, inner);
  if (name == "symbol") return draw_viewport(target, inner, viewport);
  const Rectangle own = viewport_of(inner.style, inner);
  draw_viewport(target, inner,
                {own.x, own.y, scope.style.width ? viewport.width : own.width,
                 scope.style.height ? viewport.height : own.height});
}

bool Walker::is_cycle(pugi::xml_node use, pugi::xml_node target) const {
  return is_within(use, target) || std::ranges::find(targets_, target) != targets_.end();
}

// --- Viewports and groups -----------------------------------------------------------------------

Rectangle Walker::viewport_of(const ComputedStyle& style, const Scope& scope) const {
  const LengthContext context = length_context(style, scope.viewport);
  constexpr Length kWhole = {100, LengthUnit::kPercent};
  return {resolve(style.x, LengthAxis::kHorizontal, context),
          resolve(style.y, LengthAxis::kVertical, context),
          resolve(style.width.value_or(kWhole), LengthAxis::kHorizontal, context),
          resolve(style.height.value_or(kWhole), LengthAxis::kVertical, context)};
}

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
  open_group(element, scope, clipped ? add_viewport_clip(viewport, scope) : "");
  scope.page_from_user = scope.page_from_user * *viewport_from_inside;
  scope.viewport = inside;
  draw_children(element, scope);
}

std::string Walker::add_viewport_clip(const Rectangle& viewport, const Scope& scope) {
  ClipPart part;
  part.path = rectangle_path(viewport, std::nullopt, std::nullopt);
  part.path.transform(scope.page_from_user);
  if (!is_finite(part.path)) return "";
  return builder_.add_clip({}, {std::move(part)}, "");
}

void Walker::open_group(pugi::xml_node element, Scope& scope, const std::string& clip) {
  warn_not_carried(element, scope.style);
  const GroupLook look{scope.style.opacity, clip, scope.style.display == Display::kNone};
  scope.group = builder_.add_group(element, look, scope.group);
}

// --- Shapes -------------------------------------------------------------------------------------

void Walker::draw_shape(pugi::xml_node element, ElementKind kind, const Scope& scope) {
  PathRecord record;
  record.path = element_path(element, kind, scope.style, scope.viewport, reporter_);
  if (record.path.empty()) return;
  count_points(element, record.path);
  const LengthContext context = length_context(scope.style, scope.viewport);
  record.style =
      painter_.painted_style(element, scope.style, {record.path, scope.page_from_user, context});
  record.path.transform(scope.page_from_user);
  if (!is_finite(record.path)) {
    return reporter_.warn(element, "has coordinates that are too large; it is left out");
  }
  warn_not_carried(element, scope.style);
  warn_markers(element, kind, scope.style);
  record.shape = shape_name(kind, element);
  settle_shape(record.shape, record.path);
  builder_.add_path(element, std::move(record), scope.group);
}

// --- Limits and warnings ------------------------------------------------------------------------

void Walker::count_element(pugi::xml_node element, const Scope& scope) {
  if (scope.depth > kDepthLimit) {
    throw Error(file_.place(element),
                "use draws elements deeper than " + std::to_string(kDepthLimit) + " levels");
  }
  if (targets_.empty() || ++used_elements_ <= limits_.used_elements) return;
  throw Error(file_.place(element),
              "use draws more than " + std::to_string(limits_.used_elements) + " elements");
}

void Walker::count_points(pugi::xml_node element, const Path& path) {
  points_ += path.points().size();
  if (points_ <= limits_.points) return;
  throw Error(file_.place(element),
              "the paths have more than " + std::to_string(limits_.points) + " points");
}

void Walker::warn_not_carried(pugi::xml_node element, const ComputedStyle& style) {
  const auto warn = [&](std::string_view value, const std::string& what) {
    if (!value.empty()) reporter_.warn(element, what + " is not carried");
  };
  warn(style.clip_path, "clip-path");
  warn(style.mask, "mask");
  warn(style.filter, "filter");
  warn(style.blend_mode, "mix-blend-mode");
}

void Walker::warn_markers(pugi::xml_node element, ElementKind kind, const ComputedStyle& style) {
  const bool takes_markers = kind == ElementKind::kPath || kind == ElementKind::kLine ||
                             kind == ElementKind::kPolyline || kind == ElementKind::kPolygon;
  if (!takes_markers) return;
  for (const std::string_view marker : {style.marker_start, style.marker_mid, style.marker_end}) {
    if (index_.find_reference(marker)) reporter_.warn(element, "markers are not carried");
  }
}

}  // namespace libstyle::svg
