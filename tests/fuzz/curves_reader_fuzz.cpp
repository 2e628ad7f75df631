// SPDX-License-Identifier: Apache-2.0
// Whatever the reader takes, the writer gives back: reading, writing and reading again gives equal
// documents, and a second writing equal bytes. Broken documents are passed over. What says that it
// is a style is one, or an error says why not.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "libstyle/analogy/style_document.h"
#include "libstyle/base/error.h"
#include "libstyle/curves/reader.h"
#include "libstyle/curves/writer.h"

namespace {

struct Stream {
  std::vector<libstyle::Document> documents;
  bool is_whole = true;
};

Stream read(std::string_view text) {
  libstyle::TextSource source(text);
  libstyle::Reader reader(source, "input");
  Stream stream;
  for (libstyle::Document document;;) {
    try {
      if (!reader.read(document)) return stream;
      stream.documents.push_back(document);
    } catch (const libstyle::Error&) {
      stream.is_whole = false;
    }
  }
}

std::string write(const std::vector<libstyle::Document>& documents) {
  libstyle::TextSink sink;
  for (const libstyle::Document& document : documents) write_document(sink, document);
  return sink.text;
}

void try_as_style(const libstyle::Document& document) {
  if (!is_style_document(document)) return;
  try {
    style_document(style_pairs(document), document);
  } catch (const libstyle::Error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<libstyle::Document> documents =
      read({reinterpret_cast<const char*>(data), size}).documents;
  for (const libstyle::Document& document : documents) try_as_style(document);
  const std::string text = write(documents);
  const Stream again = read(text);
  if (!again.is_whole || again.documents != documents || write(again.documents) != text) {
    std::abort();
  }
  return 0;
}
