// SPDX-License-Identifier: Apache-2.0
// Gradients as they paint one path: bounding boxes and percentages resolved, brought to the page.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <utility>

#include "converters/svg/document_builder.h"
#include "converters/svg/file_index.h"
#include "converters/svg/gradient_definition.h"
#include "converters/svg/length.h"
#include "converters/svg/reporter.h"

namespace libstyle::svg {

// What a gradient is resolved against.
struct PaintedShape {
  const Path& path;                  // in user space
  const std::optional<Box>& bounds;  // where its box is not that of the path
  const Transform& page_from_user;
  const LengthContext& context;
};

class Gradients {
 public:
  Gradients(const FileIndex& index, Reporter& reporter, DocumentBuilder& builder)
      : index_(index), reporter_(reporter), builder_(builder) {}

  // The paint that a gradient element is for a shape, its record added to the document if that has
  // none like it yet. A gradient without stops is no paint. Nothing when it cannot be used here,
  // and the paint to fall back to counts: its href is wrong, its transform or that of the shape has
  // no inverse, or the shape's box has no area.
  // A gradient without extent is a colour; `opacity` takes its alpha.
  std::optional<Paint> paint(pugi::xml_node element, const PaintedShape& shape, double& opacity);

 private:
  // The element, then the numbers of the transform and the geometry.
  using Key = std::pair<const void*, std::array<double, 12>>;

  const std::optional<GradientDefinition>& definition(pugi::xml_node element);
  std::string record_id(pugi::xml_node element, GradientRecord record);

  const FileIndex& index_;
  Reporter& reporter_;
  DocumentBuilder& builder_;
  std::map<const void*, std::optional<GradientDefinition>> definitions_;
  std::map<Key, std::string> ids_;
};

}  // namespace libstyle::svg
