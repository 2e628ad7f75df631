// SPDX-License-Identifier: Apache-2.0
#include "converters/common/document_files.h"

#include <utility>

#include "converters/common/files.h"

namespace libstyle {

void DocumentFiles::add(DocumentFile file) {
  if (names_.takes_several()) return write(file);
  if (only_) {
    throw OutputError(file.place,
                      "a second document, but this output holds one; name it with {name} or "
                      "{number}" +
                          otherwise_);
  }
  only_ = std::move(file);
}

void DocumentFiles::finish() {
  if (only_) write(*only_);
}

void DocumentFiles::write(const DocumentFile& file) {
  OutputFile output(names_.next(file.name, file.number));
  output.write(file.bytes);
  output.commit();
}

}  // namespace libstyle
