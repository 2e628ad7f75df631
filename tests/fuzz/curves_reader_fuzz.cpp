// SPDX-License-Identifier: Apache-2.0
// Whatever the reader takes, the writer gives back: reading, writing and reading again gives equal
// documents, and a second writing equal bytes.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "libstyle/base/error.h"
#include "libstyle/curves/reader.h"
#include "libstyle/curves/writer.h"

namespace {

std::vector<libstyle::Document> read(std::string_view text) {
  libstyle::TextSource source(text);
  libstyle::Reader reader(source, "input");
  std::vector<libstyle::Document> documents;
  for (libstyle::Document document; reader.read(document);) documents.push_back(document);
  return documents;
}

std::string write(const std::vector<libstyle::Document>& documents) {
  libstyle::TextSink sink;
  for (const libstyle::Document& document : documents) write_document(sink, document);
  return sink.text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<libstyle::Document> documents;
  try {
    documents = read({reinterpret_cast<const char*>(data), size});
  } catch (const libstyle::Error&) {
    return 0;
  }
  const std::string text = write(documents);
  const std::vector<libstyle::Document> again = read(text);  // an Error here is a finding
  if (again != documents || write(again) != text) std::abort();
  return 0;
}
