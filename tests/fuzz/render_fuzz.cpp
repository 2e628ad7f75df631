// SPDX-License-Identifier: Apache-2.0
// Whatever the reader takes can be drawn, or ends in an Error.
#include <cstdint>
#include <string_view>

#include "converters/cairo/picture.h"
#include "libstyle/base/error.h"
#include "libstyle/curves/reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    libstyle::TextSource source({reinterpret_cast<const char*>(data), size});
    libstyle::Reader reader(source, "input");
    libstyle::PictureSettings settings;
    settings.size.width = settings.size.height = 64;  // small: speed finds more than pixels do
    libstyle::Document document;
    while (reader.read(document)) {
      libstyle::TextSink sink;
      libstyle::Picture picture(sink, settings, {});
      picture.add(document);
      picture.finish();
    }
  } catch (const libstyle::Error&) {
  }
  return 0;
}
