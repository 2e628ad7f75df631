// SPDX-License-Identifier: Apache-2.0
// Makes records of what is drawn, and brings it to the page.
#pragma once

#include <functional>
#include <optional>
#include <pugixml.hpp>

#include "converters/svg/canvas.h"
#include "converters/svg/clip_paths.h"
#include "converters/svg/document_builder.h"
#include "converters/svg/markers.h"
#include "converters/svg/painter.h"
#include "converters/svg/walker.h"

namespace libstyle::svg {

class DocumentCanvas final : public Canvas {
 public:
  DocumentCanvas(Drawing& drawing, DocumentBuilder& builder)
      : drawing_(drawing),
        builder_(builder),
        painter_(drawing.index, drawing.reporter, builder),
        clips_(drawing, builder),
        markers_(drawing, *this) {}

  bool open_group(pugi::xml_node element, Scope& scope,
                  const std::optional<Rectangle>& viewport) override;
  void draw_path(pugi::xml_node element, ElementKind kind, Path path, const Scope& scope) override;

 private:
  std::string add_viewport_clip(const Rectangle& viewport, const Scope& scope);
  void add_path_and_markers(pugi::xml_node element, PathRecord record, const Scope& scope,
                            const std::function<void()>& draw_markers);
  std::string group_around(PathRecord& path, const Scope& scope, bool marked);
  void warn_not_carried(pugi::xml_node element, const ComputedStyle& style);

  Drawing& drawing_;
  DocumentBuilder& builder_;
  Painter painter_;
  ClipPaths clips_;
  Markers markers_;
};

}  // namespace libstyle::svg
