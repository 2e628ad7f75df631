// SPDX-License-Identifier: Apache-2.0
// How a shape is painted: its computed properties as the style of a record.
#pragma once

#include <pugixml.hpp>

#include "converters/svg/computed_style.h"
#include "converters/svg/document_builder.h"
#include "converters/svg/file_index.h"
#include "converters/svg/gradients.h"
#include "converters/svg/paint_context.h"
#include "converters/svg/reporter.h"
#include "libstyle/curves/style.h"

namespace libstyle::svg {

class Painter {
 public:
  Painter(const FileIndex& index, Reporter& reporter, DocumentBuilder& builder)
      : index_(index), reporter_(reporter), gradients_(index, reporter, builder) {}

  // Adds the records of the gradients that the style refers to.
  Style painted_style(pugi::xml_node element, const ComputedStyle& computed,
                      const PaintContext& context, const PaintedShape& shape);

 private:
  std::optional<Paint> resolve_paint(pugi::xml_node element, const SpecifiedPaint& specified,
                                     const ComputedStyle& computed, const PaintedShape& shape,
                                     double& opacity);

  const FileIndex& index_;
  Reporter& reporter_;
  Gradients gradients_;
};

}  // namespace libstyle::svg
