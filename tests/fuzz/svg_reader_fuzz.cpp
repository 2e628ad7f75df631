// SPDX-License-Identifier: Apache-2.0
// Any bytes: the SVG reader ends in a document or an Error, soon, and what it gives can be written
// as curves and read back the same.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "converters/svg/svg_reader.h"
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
  return 0;
}
