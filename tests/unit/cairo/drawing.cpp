// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/cairo/drawing.h"

#include <utility>

#include "converters/cairo/picture.h"
#include "libstyle/geometry/path_data.h"
#include "tests/support/pixdiff.h"

namespace libstyle {

Document make_page(Records records) {
  Document document;
  document.header.width = 100;
  document.header.height = 100;
  document.records = std::move(records);
  return document;
}

PathRecord filled(std::string_view data, Color color) {
  PathRecord record;
  record.path = parse_path_data(data);
  record.style.fill = color;
  return record;
}

PathRecord stroked(std::string_view data, double width, Color color) {
  PathRecord record;
  record.path = parse_path_data(data);
  record.style.stroke = color;
  record.style.stroke_width = width;
  return record;
}

GroupRecord group(std::string id, double opacity, std::string clip) {
  GroupRecord record;
  record.id = std::move(id);
  record.opacity = opacity;
  record.clip = std::move(clip);
  return record;
}

ClipRecord clip(std::string id, std::vector<ClipPart> parts) {
  ClipRecord record;
  record.id = std::move(id);
  record.parts = std::move(parts);
  return record;
}

ClipPart part(std::string_view data, FillRule rule) { return {parse_path_data(data), rule, ""}; }

std::string draw_png(const Document& document, const WarningHandler& warn) {
  TextSink sink;
  Picture picture(sink, {}, warn);
  picture.add(document);
  picture.finish();
  return sink.text;
}

Raster draw(const Document& document, const WarningHandler& warn) {
  return decode_png(draw_png(document, warn));
}

std::size_t count_different(const Raster& a, const Raster& b, int bound) {
  return compare(a, b, {bound, 0, 255, false}).bad;
}

double covered_area(const Raster& image) {
  double area = 0;
  for (const Pixel& pixel : image.pixels) area += pixel[3] / 255.0;
  return area;
}

}  // namespace libstyle
