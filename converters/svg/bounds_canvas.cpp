// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/bounds_canvas.h"

#include "libstyle/geometry/path_segments.h"

namespace libstyle::svg {

bool BoundsCanvas::open_group(pugi::xml_node /*element*/, Scope& scope,
                              const std::optional<Rectangle>& /*viewport*/) {
  return scope.style.display != Display::kNone;
}

void BoundsCanvas::draw_path(pugi::xml_node /*element*/, ElementKind /*kind*/, Path path,
                             const Scope& scope) {
  if (scope.style.display == Display::kNone) return;
  path.transform(scope.page_from_user);
  bounds_.include(bounding_box(path));
}

Box measure_members(Drawing& drawing, pugi::xml_node group, const Scope& scope) {
  Scope own = scope;
  own.page_from_user = Transform{};
  BoundsCanvas canvas;
  Walker(drawing, canvas, WalkKind::kRepeated).draw_children(group, own);
  return canvas.bounds();
}

}  // namespace libstyle::svg
