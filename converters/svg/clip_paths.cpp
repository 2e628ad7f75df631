// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/clip_paths.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "converters/svg/carried_keys.h"
#include "converters/svg/cascade.h"
#include "converters/svg/scanner.h"
#include "libstyle/geometry/path_segments.h"

namespace libstyle::svg {
namespace {

constexpr std::size_t kNestingLimit = 32;  // clips that are clipped themselves

// Whether the parts of a clipPath and the clips on them are what SVG says (see carried_keys.h),
// rather than what librsvg makes of them.
bool is_united(pugi::xml_node clip) {
  return std::string_view(clip.attribute(kCarriedParts).value()) == kUnited;
}

// Gathers what a clipPath lets through.
class ClipCanvas final : public Canvas {
 public:
  ClipCanvas(ClipPaths& clips, bool united, Reporter& reporter)
      : clips_(clips), united_(united), reporter_(reporter) {}

  // SVG 1.1, section 14.3.5: a clipPath holds shapes and texts, and `use` that refers to them
  // directly; groups let nothing through. What has bounds is a part of a text.
  bool open_group(pugi::xml_node element, Scope& scope,
                  const std::optional<Rectangle>& /*viewport*/) override {
    const bool is_use = std::string_view(element.name()) == "use" &&
                        std::string_view(element.parent().name()) == "clipPath";
    if (!is_use && !scope.bounds) return false;
    warn_clipped(element, scope.style);
    return scope.style.display != Display::kNone;
  }

  void draw_path(pugi::xml_node element, ElementKind /*kind*/, Path path,
                 const Scope& scope) override {
    const ComputedStyle& style = scope.style;
    if (style.display == Display::kNone || style.visibility == Visibility::kHidden) return;
    ClipPart part;
    if (united_) {
      part.clip = clips_.find_or_add(element, scope,
                                     [&] { return scope.bounds.value_or(bounding_box(path)); });
    } else {
      warn_clipped(element, style);
    }
    part.path = std::move(path);
    part.path.transform(scope.page_from_user);
    part.rule = style.clip_rule;
    const pugi::xml_attribute carried = element.attribute(kCarriedKeys);
    if (carried && !restore_carried_extras(carried.value(), part)) {
      reporter_.warn(element, std::string(kCarriedKeys) + " is wrong; left out");
    }
    parts_.push_back(std::move(part));
  }

  std::vector<ClipPart> take_parts() {
    if (!united_) join_parts();
    return std::move(parts_);
  }

 private:
  void warn_clipped(pugi::xml_node element, const ComputedStyle& style) {
    if (style.clip_path.empty()) return;
    reporter_.warn(element, "clip-path within a clipPath is not carried, as in librsvg");
  }

  // librsvg takes all the outlines for those of one shape, filled by the rule of the last.
  void join_parts() {
    if (parts_.size() < 2) return;
    ClipPart whole;
    for (const ClipPart& part : parts_) whole.path.append(part.path);
    whole.rule = parts_.back().rule;
    parts_ = {std::move(whole)};
  }

  ClipPaths& clips_;
  bool united_;
  Reporter& reporter_;
  std::vector<ClipPart> parts_;
};

bool is_in_bounds_units(pugi::xml_node clip) {
  return equal_ignoring_case(clip.attribute("clipPathUnits").value(), "objectBoundingBox");
}

bool has_area(const Box& box) { return box.width() > 0 && box.height() > 0; }

Transform user_from_bounds(const Box& bounds) {
  return {bounds.width(), 0, 0, bounds.height(), bounds.low.x, bounds.low.y};
}

}  // namespace

std::string ClipPaths::find_or_add(pugi::xml_node element, const Scope& scope,
                                   const std::function<Box()>& bounds) {
  const pugi::xml_node clip = find_clip(element, scope.style.clip_path);
  if (!clip) return "";
  const auto last = last_uses_.find(clip.internal_object());
  if (last != last_uses_.end() && last->second.page_from_user == scope.page_from_user &&
      last->second.viewport == scope.viewport) {
    return last->second.id;
  }
  if (is_in_bounds_units(clip) && !has_area(bounds())) return "";  // SVG 1.1, section 7.11
  std::string id = add(clip, scope, bounds);
  if (!is_in_bounds_units(clip)) {
    last_uses_[clip.internal_object()] = {scope.page_from_user, scope.viewport, id};
  }
  return id;
}

// The clipPath that an element names, if it can be used.
pugi::xml_node ClipPaths::find_clip(pugi::xml_node element, std::string_view value) {
  if (value.empty()) return {};
  std::string_view rest;
  const std::string_view reference = take_url(value, rest);
  const pugi::xml_node clip = drawing_.index.find_reference(reference);
  if (std::string_view(clip.name()) != "clipPath" || !trimmed(rest).empty()) {
    drawing_.reporter.warn(
        element, "clip-path is \"" + std::string(value) + "\", which is no clipPath in the file");
    return {};
  }
  if (std::ranges::find(open_, clip) != open_.end()) {
    drawing_.reporter.warn(element, "clip-path refers to itself; it is left out");
    return {};
  }
  if (open_.size() == kNestingLimit) {
    drawing_.reporter.warn(element, "clip-paths nest too deep; this one is left out");
    return {};
  }
  return clip;
}

std::string ClipPaths::add(pugi::xml_node clip, const Scope& scope,
                           const std::function<Box()>& bounds) {
  Scope inside;
  inside.style = style_in_place(clip, drawing_.index.sheets());
  inside.viewport = scope.viewport;
  inside.page_from_user = scope.page_from_user;
  open_.push_back(clip);
  std::string outer_clip;
  if (is_united(clip)) {
    outer_clip = find_or_add(clip, inside, bounds);
  } else if (!inside.style.clip_path.empty()) {
    drawing_.reporter.warn(clip, "clip-path on a clipPath is not carried, as in librsvg");
  }
  if (is_in_bounds_units(clip)) {
    inside.page_from_user = inside.page_from_user * user_from_bounds(bounds());
  }
  if (inside.style.transform) {
    inside.page_from_user = inside.page_from_user * *inside.style.transform;
  }
  ClipCanvas canvas(*this, is_united(clip), drawing_.reporter);
  Walker(drawing_, canvas, WalkKind::kRepeated).draw_children(clip, inside);
  open_.pop_back();
  return builder_.add_clip(clip, canvas.take_parts(), outer_clip);
}

}  // namespace libstyle::svg
