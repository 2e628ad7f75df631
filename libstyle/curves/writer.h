// SPDX-License-Identifier: Apache-2.0
// Writes the curves format. Keys come in a fixed order, keys at their initial value are left out,
// numbers are the shortest that read back the same: equal documents give equal bytes.
#pragma once

#include <string>

#include "libstyle/base/bytes.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// Append one line, newline included. Numbers are finite, texts UTF-8 (else Error), extras JSON in
// one line.
void append_header(std::string& text, const Header& header);
void append_record(std::string& text, const Record& record);

// Writes a document in pieces of about a megabyte, all of it by the time the call returns.
void write_document(ByteSink& sink, const Document& document);

}  // namespace libstyle
