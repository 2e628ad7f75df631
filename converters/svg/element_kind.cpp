// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/element_kind.h"

#include <algorithm>
#include <iterator>

#include "converters/svg/xml.h"

namespace libstyle::svg {
namespace {

struct NamedKind {
  std::string_view name;
  ElementKind kind;
};

constexpr NamedKind kKinds[] = {
    {"a", ElementKind::kGroup},
    {"animate", ElementKind::kActive},
    {"animateColor", ElementKind::kActive},
    {"animateMotion", ElementKind::kActive},
    {"animateTransform", ElementKind::kActive},
    {"circle", ElementKind::kCircle},
    {"clipPath", ElementKind::kNeverDrawn},
    {"color-profile", ElementKind::kNeverDrawn},
    {"cursor", ElementKind::kNeverDrawn},
    {"defs", ElementKind::kNeverDrawn},
    {"desc", ElementKind::kNeverDrawn},
    {"ellipse", ElementKind::kEllipse},
    {"filter", ElementKind::kNeverDrawn},
    {"font", ElementKind::kNeverDrawn},
    {"font-face", ElementKind::kNeverDrawn},
    {"g", ElementKind::kGroup},
    {"line", ElementKind::kLine},
    {"linearGradient", ElementKind::kNeverDrawn},
    {"marker", ElementKind::kNeverDrawn},
    {"mask", ElementKind::kNeverDrawn},
    {"metadata", ElementKind::kNeverDrawn},
    {"path", ElementKind::kPath},
    {"pattern", ElementKind::kNeverDrawn},
    {"polygon", ElementKind::kPolygon},
    {"polyline", ElementKind::kPolyline},
    {"radialGradient", ElementKind::kNeverDrawn},
    {"rect", ElementKind::kRect},
    {"script", ElementKind::kActive},
    {"set", ElementKind::kActive},
    {"style", ElementKind::kNeverDrawn},
    {"svg", ElementKind::kSvg},
    {"switch", ElementKind::kSwitch},
    {"symbol", ElementKind::kNeverDrawn},
    {"text", ElementKind::kText},
    {"title", ElementKind::kNeverDrawn},
    {"use", ElementKind::kUse},
    {"view", ElementKind::kNeverDrawn},
};
static_assert(std::ranges::is_sorted(kKinds, {}, &NamedKind::name));

}  // namespace

ElementKind element_kind(std::string_view name) {
  const auto* const found = std::ranges::lower_bound(kKinds, name, {}, &NamedKind::name);
  if (found != std::end(kKinds) && found->name == name) return found->kind;
  return is_foreign(name) ? ElementKind::kForeign : ElementKind::kNotCarried;
}

}  // namespace libstyle::svg
