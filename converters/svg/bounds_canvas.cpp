// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/bounds_canvas.h"

#include "converters/svg/measured_box.h"

namespace libstyle::svg {

bool BoundsCanvas::open_group(pugi::xml_node /*element*/, Scope& scope,
                              const std::optional<Rectangle>& /*viewport*/) {
  return scope.style.display != Display::kNone;
}

void BoundsCanvas::draw_path(pugi::xml_node /*element*/, ElementKind /*kind*/, Path path,
                             const Scope& scope) {
  if (scope.style.display == Display::kNone) return;
  const std::optional<Box> box =
      scope.bounds ? scope.bounds : measured_box(path, scope.page_from_user);
  if (box) bounds_.include(mapped_box(*box, group_from_page_ * scope.page_from_user));
}

Box measure_members(Drawing& drawing, pugi::xml_node group, const Scope& scope) {
  const std::optional<Transform> group_from_page = inverse(scope.page_from_user);
  if (!group_from_page) return {};
  BoundsCanvas canvas(*group_from_page);
  Walker(drawing, canvas, WalkKind::kRepeated).draw_members(group, scope);
  return canvas.bounds();
}

}  // namespace libstyle::svg
