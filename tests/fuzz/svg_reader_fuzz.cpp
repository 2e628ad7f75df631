// SPDX-License-Identifier: Apache-2.0
// Any bytes, all the way of svg2curves, render and curves2svg: the SVG reader ends in a document or
// an Error, soon, and what it gives can be written as curves and read back the same, drawn, and
// written as SVG that is read again.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "converters/cairo/picture.h"
#include "converters/svg/svg_reader.h"
#include "converters/svg/svg_writer.h"
#include "libstyle/curves/reader.h"
#include "libstyle/curves/writer.h"

namespace libstyle {
namespace {

// Small enough that a slow input is a fault of ours.
svg::SvgReadOptions small_limits() {
  svg::SvgReadOptions options;
  options.limits.used_elements = 1000;
  options.limits.points = 100'000;
  options.limits.match_steps = 100'000;
  options.limits.text_work = 2'000;
  options.limits.xml.entities.bytes = 100'000;
  return options;
}

void check_round_trip(const Document& document) {
  TextSink written;
  write_document(written, document);
  TextSource source(written.text);
  Reader reader(source, "written");
  Document back;
  if (!reader.read(back) || !(back == document)) std::abort();
}

void draw(const Document& document) {
  PictureSettings settings;
  settings.size.width = settings.size.height = 32;  // small: speed finds more than pixels do
  TextSink sink;
  Picture picture(sink, settings, {});
  picture.add(document);
  picture.finish();
}

void write_and_read_svg(const Document& document) {
  TextSink written;
  svg::write_svg(written, document, [](const Warning&) {});
  svg::read_svg(std::move(written.text), "written", small_limits(), [](const Warning&) {});
}

// Runs what may end in an Error.
template <typename Work>
void attempt(Work work) {
  try {
    work();
  } catch (const Error&) {
  }
}

}  // namespace
}  // namespace libstyle

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace libstyle;
  std::string text(reinterpret_cast<const char*>(data), size);
  Document document;
  try {
    document = svg::read_svg(std::move(text), "fuzz", small_limits(), [](const Warning&) {});
  } catch (const Error&) {
    return 0;
  }
  check_round_trip(document);
  attempt([&] { draw(document); });
  attempt([&] { write_and_read_svg(document); });
  return 0;
}
