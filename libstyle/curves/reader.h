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
  std::size_t records = 10'000'000;                   // one document
};

class Reader {
 public:
  // `name` is how messages call the input. The source outlives the reader.
  Reader(ByteSource& source, std::string name, const ReaderLimits& limits = {});
  ~Reader();

  // Replaces `document` by the next one of the stream. Returns false, with `document` empty, at the
  // end of the stream.
  // Throws Error with file and line: not JSON or not UTF-8, a key that is missing, twice there or
  // of the wrong type or range, bad path data, an array along the curve of the wrong length, an id
  // that two records have, a record before any header, an unknown version, a stream that ends in
  // the middle of a line, a line or document over the limits. Not checked: what records refer to
  // ("in", "clip", "curve", "of", "url(#id)"). A reference means a record before it in the
  // document; where there is none it has no effect.
  //
  // After an Error the next call goes on with the next document: everything up to the next header
  // belongs to the broken one. A header is a JSON object with "curves" and without "type", or, even
  // if the rest of it is broken, any line that begins with {"curves": as programs write it; nothing
  // else can be taken for one. A line over the limit, or that the source fails to give, ends the
  // stream.
  bool read(Document& document);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace libstyle
