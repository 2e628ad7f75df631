// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/walker.h"

#include <algorithm>
#include <utility>

#include "converters/svg/cascade.h"
#include "converters/svg/conditions.h"
#include "converters/svg/element_path.h"
#include "libstyle/geometry/path_segments.h"

namespace libstyle::svg {
namespace {

// Elements within elements where `use` and markers count too: at most 3 MB of stack.
constexpr std::size_t kDepthLimit = 1200;

// An element with more in its attributes, which are read each time, counts as several.
constexpr std::size_t kElementBytes = 4096;

std::size_t attribute_bytes(pugi::xml_node node) {
  std::size_t bytes = 0;
  for (const pugi::xml_attribute attribute : node.attributes()) {
    bytes += std::string_view(attribute.value()).size();
  }
  return bytes;
}

bool is_finite(const Path& path, const Transform& map) {
  return std::ranges::all_of(path.points(), [&](Point p) { return libstyle::is_finite(map(p)); });
}

constexpr Length kWhole = {100, LengthUnit::kPercent};

Rectangle viewport_of(const Scope& scope) {
  const LengthContext context = length_context(scope.style, scope.viewport);
  return {resolve(scope.style.x, LengthAxis::kHorizontal, context),
          resolve(scope.style.y, LengthAxis::kVertical, context),
          resolve(scope.style.width.value_or(kWhole), LengthAxis::kHorizontal, context),
          resolve(scope.style.height.value_or(kWhole), LengthAxis::kVertical, context)};
}

// librsvg clips a symbol to its viewBox where the `use` says so, and where the symbol itself says
// that it is not to be clipped, but not where it says nothing or that it is.
bool symbol_clips(const ComputedStyle& symbol, const ComputedStyle& use) {
  return use.overflow == Overflow::kHidden || symbol.overflow == Overflow::kVisible;
}

// Fonts have a rule of their own for what is inside, and their edges are not those of shapes
// (SVG 1.1, section 11.7.3).
void set_rules_of_fonts(ComputedStyle& style) {
  style.crisp_edges = false;
  style.fill_rule = FillRule::kNonZero;
  style.clip_rule = FillRule::kNonZero;
}

// Opacity, clip and the like are those of the text as a whole (SVG 1.1, chapter 14).
Scope scope_within_text(const Scope& text, const InheritedProperties& style) {
  Scope scope = text;
  scope.style = {};
  static_cast<InheritedProperties&>(scope.style) = style;
  set_rules_of_fonts(scope.style);
  return scope;
}

// The child of `part` that `descendant` is, or is within; `child` is where to begin to look.
std::size_t child_around(const TextContent& text, std::size_t part, std::size_t child,
                         std::size_t descendant) {
  if (child == part || child > descendant) child = part + 1;
  while (text.parts[child].end <= descendant) child = text.parts[child].end;
  return child;
}

pugi::xml_node own_characters(pugi::xml_node element) { return element.find_child(is_characters); }

}  // namespace

void count_used(Drawing& drawing, pugi::xml_node node) {
  drawing.used_elements += 1 + attribute_bytes(node) / kElementBytes;
  if (drawing.used_elements <= drawing.limits.used_elements) return;
  throw Error(drawing.file.place(node),
              "use draws more than " + std::to_string(drawing.limits.used_elements) + " elements");
}

// --- Structure ----------------------------------------------------------------------------------

void Walker::draw_children(pugi::xml_node element, const Scope& scope) {
  for (const pugi::xml_node child : element.children()) {
    count_node(child);
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
  check_depth(element, scope);
  switch (kind) {
    case ElementKind::kGroup:
      return draw_group(element, scope);
    case ElementKind::kSwitch:
      return draw_switch(element, scope);
    case ElementKind::kSvg:
      return draw_nested_svg(element, scope);
    case ElementKind::kUse:
      return draw_use(element, scope);
    case ElementKind::kText:
      return draw_text(element, scope);
    case ElementKind::kNotCarried:
      return drawing_.reporter.warn(element, std::string(element.name()) + " is not carried");
    default:
      return draw_shape(element, kind, scope);
  }
}

Scope Walker::enter(pugi::xml_node element, const Scope& parent) const {
  Scope scope;
  scope.style = cascade(element, parent.style, drawing_.index.sheets());
  scope.paint_context = parent.paint_context;
  scope.page_from_user = parent.page_from_user;
  if (scope.style.transform) scope.page_from_user = scope.page_from_user * *scope.style.transform;
  scope.viewport = parent.viewport;
  scope.group = parent.group;
  scope.path_clip = parent.path_clip;
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
    count_node(child);
    if (child.type() == pugi::node_element && conditions_hold(child)) return draw(child, scope);
  }
}

void Walker::draw_nested_svg(pugi::xml_node element, Scope& scope) {
  const std::optional<View> view = read_view(element);
  if (!view) {
    return drawing_.reporter.warn(element,
                                  "its viewBox or preserveAspectRatio is wrong; it is left out");
  }
  draw_viewport(element, scope, viewport_of(scope), *view);
}

// --- use ----------------------------------------------------------------------------------------

void Walker::draw_use(pugi::xml_node element, Scope& scope) {
  const pugi::xml_node target = drawing_.index.find_target(element);
  if (!target) {
    return drawing_.reporter.warn(
        element, "refers to \"" + std::string(link_of(element)) + "\", which is not in the file");
  }
  if (std::ranges::find(uses_, element) != uses_.end()) {
    return drawing_.reporter.warn(element, "refers to itself; it is left out");
  }
  const std::optional<Rectangle> viewport = read_use_viewport(element, scope);
  if (!viewport) return;
  // A symbol opens its viewport at x and y, anything else is moved there (SVG 1.1, section 5.6);
  // the move counts for the clip-path of the use, too.
  const bool is_symbol = std::string_view(target.name()) == "symbol";
  if (!is_symbol) {
    scope.page_from_user =
        scope.page_from_user * Transform::translation({viewport->x, viewport->y});
  }
  if (!canvas_.open_group(element, scope, std::nullopt)) return;
  draw_target(target, element, scope, *viewport);
}

void Walker::draw_target(pugi::xml_node target, pugi::xml_node use, const Scope& scope,
                         const Rectangle& viewport) {
  Scope inside = scope;
  inside.paint_context = paints_of(scope.style, scope.paint_context);
  uses_.push_back(use);
  if (std::string_view(target.name()) == "symbol") {
    draw_symbol(target, use, inside, viewport);
  } else {
    count_node(target);
    draw(target, inside);
  }
  uses_.pop_back();
}

void Walker::draw_members(pugi::xml_node element, const Scope& scope) {
  if (std::string_view(element.name()) != "use") return draw_children(element, scope);
  const pugi::xml_node target = drawing_.index.find_target(element);
  const std::optional<Rectangle> viewport = read_use_viewport(element, scope);
  if (target && viewport) draw_target(target, element, scope, *viewport);
}

// Nothing where the use is not drawn: a size is 0, or an attribute is wrong. Width and height
// matter to a symbol alone, as librsvg has it.
std::optional<Rectangle> Walker::read_use_viewport(pugi::xml_node use, const Scope& scope) {
  const LengthContext context = length_context(scope.style, scope.viewport);
  bool wrong = false;
  const auto length = [&](const char* name, LengthAxis axis, Length initial) {
    const pugi::xml_attribute attribute = use.attribute(name);
    const std::optional<Length> given =
        attribute ? parse_leading_length(attribute.value()) : initial;
    wrong = wrong || !given;
    return resolve(given.value_or(initial), axis, context);
  };
  const Rectangle viewport = {length("x", LengthAxis::kHorizontal, {}),
                              length("y", LengthAxis::kVertical, {}),
                              length("width", LengthAxis::kHorizontal, kWhole),
                              length("height", LengthAxis::kVertical, kWhole)};
  if (wrong || viewport.width < 0 || viewport.height < 0) {
    drawing_.reporter.warn(use, "its x, y, width or height is wrong; it is left out");
    return std::nullopt;
  }
  if (viewport.width == 0 || viewport.height == 0) return std::nullopt;
  return viewport;
}

// As librsvg has it, a symbol has neither display nor transform nor anything that groups have, and
// its percentages are those of the viewport around it unless it has a viewBox. What is wrong in its
// view is not looked at; a viewBox without size leaves what is in it where the symbol is used.
void Walker::draw_symbol(pugi::xml_node symbol, pugi::xml_node use, const Scope& scope,
                         const Rectangle& viewport) {
  Scope inner = enter(symbol, scope);
  check_depth(use, inner);
  count_node(symbol);
  const bool clipped = symbol_clips(inner.style, scope.style);
  static_cast<OwnProperties&>(inner.style) = {};
  inner.page_from_user = scope.page_from_user;
  const AspectRatio ratio =
      parse_aspect_ratio(symbol.attribute("preserveAspectRatio").value()).value_or(AspectRatio{});
  const std::optional<Rectangle> box = parse_view_box(symbol.attribute("viewBox").value());
  if (!box) {
    inner.page_from_user = inner.page_from_user * Transform::translation({viewport.x, viewport.y});
  } else if (const auto map = viewport_from_view_box(viewport, *box, ratio)) {
    inner.page_from_user = inner.page_from_user * *map;
    inner.viewport = {box->width, box->height};
  }
  const auto clip = box && clipped ? box : std::nullopt;
  if (canvas_.open_group(symbol, inner, clip)) draw_children(symbol, inner);
}

// --- Viewports and shapes -----------------------------------------------------------------------

void Walker::draw_viewport(pugi::xml_node element, Scope& scope, const Rectangle& viewport,
                           const View& view) {
  if (!(viewport.width > 0 && viewport.height > 0)) return;
  std::optional<Transform> viewport_from_inside = Transform::translation({viewport.x, viewport.y});
  Vector inside = {viewport.width, viewport.height};
  if (view.view_box) {
    viewport_from_inside = viewport_from_view_box(viewport, *view.view_box, view.ratio);
    inside = {view.view_box->width, view.view_box->height};
  }
  if (!viewport_from_inside) {  // a viewBox without size; librsvg goes on as if there were none
    viewport_from_inside = Transform{};
    inside = scope.viewport;
  }
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
  draw_outline(element, kind, std::move(path), scope);
}

void Walker::draw_outline(pugi::xml_node element, ElementKind kind, Path path, const Scope& scope) {
  if (path.empty()) return;
  count_points(element, path);
  if (!is_finite(path, scope.page_from_user)) {
    return drawing_.reporter.warn(element, "has coordinates that are too large; it is left out");
  }
  canvas_.draw_path(element, kind, std::move(path), scope);
}

// --- Text ---------------------------------------------------------------------------------------

void Walker::draw_text(pugi::xml_node element, Scope& scope) {
  const SvgLimits& limits = drawing_.limits;
  const std::size_t work_left = limits.text_work - drawing_.text_work;
  const TextContent text =
      read_text_content(element, scope, drawing_.index, work_left, drawing_.reporter);
  drawing_.text_work += std::min(text.work, work_left);
  const auto leave_out = [&](const std::string& why) {
    drawing_.reporter.warn(element, "is left out: " + why);
  };
  if (text.work > work_left) {
    return leave_out("the file has more than " + std::to_string(limits.text_work) +
                     " characters of text");
  }
  if (text.longest > limits.text_length) {
    return leave_out("it has more than " + std::to_string(limits.text_length) +
                     " characters in one piece");
  }
  std::vector<TextRun> runs;
  try {
    runs = outline_text(text);
  } catch (const Error& error) {
    return leave_out(error.what());
  }
  set_rules_of_fonts(scope.style);
  scope.bounds.emplace();
  for (const TextRun& run : runs) scope.bounds->include(bounding_box(run.path));
  if (!runs.empty()) draw_text_part(text, 0, runs, scope);
}

// A part of several runs is a group. Characters of its own have no element then: their text node
// stands for it.
void Walker::draw_text_part(const TextContent& text, std::size_t part, std::span<TextRun> runs,
                            Scope& scope) {
  const pugi::xml_node element = text.parts[part].element;
  if (runs.size() == 1 && runs.front().part == part) {
    return draw_outline(element, ElementKind::kText, std::move(runs.front().path), scope);
  }
  if (!canvas_.open_group(element, scope, std::nullopt)) return;
  std::size_t child = part;
  while (!runs.empty()) {
    if (runs.front().part == part) {
      const Scope inside = scope_within_text(scope, text.parts[part].style);
      draw_outline(own_characters(element), ElementKind::kText, std::move(runs.front().path),
                   inside);
      runs = runs.subspan(1);
      continue;
    }
    child = child_around(text, part, child, runs.front().part);
    const std::size_t end = text.parts[child].end;
    const auto beyond = std::ranges::find_if(
        runs, [&](const TextRun& run) { return run.part < child || run.part >= end; });
    const auto count = static_cast<std::size_t>(beyond - runs.begin());
    Scope inside = scope_within_text(scope, text.parts[child].style);
    draw_text_part(text, child, runs.first(count), inside);
    runs = runs.subspan(count);
  }
}

// --- Limits -------------------------------------------------------------------------------------

void Walker::check_depth(pugi::xml_node element, const Scope& scope) const {
  if (scope.depth <= kDepthLimit) return;
  throw Error(drawing_.file.place(element),
              "use draws elements deeper than " + std::to_string(kDepthLimit) + " levels");
}

// What is passed over counts too: it takes its time each time.
void Walker::count_node(pugi::xml_node node) {
  if (kind_ == WalkKind::kRepeated || !uses_.empty()) count_used(drawing_, node);
}

void Walker::count_points(pugi::xml_node element, const Path& path) {
  drawing_.points += path.points().size();
  if (drawing_.points <= drawing_.limits.points) return;
  throw Error(drawing_.file.place(element),
              "the paths have more than " + std::to_string(drawing_.limits.points) + " points");
}

}  // namespace libstyle::svg
