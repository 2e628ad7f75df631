// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/svg_reader.h"

#include <utility>

#include "converters/svg/cascade.h"
#include "converters/svg/document_canvas.h"
#include "converters/svg/file_index.h"
#include "converters/svg/page.h"
#include "converters/svg/reporter.h"
#include "converters/svg/view_box.h"
#include "converters/svg/walker.h"

namespace libstyle::svg {
namespace {

void set_page(Header& header, const Page& page) {
  header.width = page.width;
  header.height = page.height;
  header.page_width = page.width_text;
  header.page_height = page.height_text;
}

void draw_root(Drawing& drawing, DocumentBuilder& builder, const Page& page,
               const ComputedStyle& style) {
  Scope scope;
  scope.style = style;
  scope.page_from_user = style.transform.value_or(Transform{});
  scope.viewport = page.viewport;
  DocumentCanvas canvas(drawing, builder);
  // Transform and clip are those of the page, around the viewBox.
  canvas.open_group(drawing.file.root(), scope, std::nullopt);
  scope.page_from_user = scope.page_from_user * *page.page_from_user;
  Walker(drawing, canvas, WalkKind::kFirst).draw_children(drawing.file.root(), scope);
}

}  // namespace

Document read_svg(std::string text, const std::string& name, const SvgReadOptions& options,
                  const WarningHandler& warn) {
  const XmlFile file(std::move(text), name, options.limits.xml, warn);
  Reporter reporter(file, warn);
  const FileIndex index(file, options.style_sheet, options.limits.match_steps, reporter, warn);
  const ComputedStyle style = cascade(file.root(), {}, index.sheets());
  const Page page = read_page(file.root(), style);
  if (!read_view(file.root())) {
    reporter.warn(file.root(),
                  "its viewBox or preserveAspectRatio is wrong; nothing is drawn, as in librsvg");
  }

  Document document;
  set_page(document.header, page);
  DocumentBuilder builder(file, reporter, document);
  Drawing drawing{file, index, options.limits, reporter};
  if (page.page_from_user) draw_root(drawing, builder, page, style);
  builder.add_carried_records(file.root());
  return document;
}

}  // namespace libstyle::svg
