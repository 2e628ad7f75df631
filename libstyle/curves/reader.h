// SPDX-License-Identifier: Apache-2.0
// Reads the curves format, one document at a time: memory is bounded by the largest document, not
// by the stream.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "libstyle/base/bytes.h"
#include "libstyle/curves/document.h"

namespace libstyle {

struct ReaderLimits {
  std::size_t record_bytes = std::size_t{256} << 20;  // one line
};

class Reader {
 public:
  // `name` is how messages call the input. The source outlives the reader.
  Reader(ByteSource& source, std::string name, const ReaderLimits& limits = {});
  ~Reader();

  // Replaces `document` by the next one of the stream. Returns false, with `document` empty, at the
  // end of the stream.
  // Throws Error with file and line: not JSON, a wrong type of value, bad path data, an array along
  // the curve of the wrong length, a record before any header, an unknown version, a last line
  // without its newline that is not whole, a line over the limit.
  bool read(Document& document);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace libstyle
