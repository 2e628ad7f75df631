// SPDX-License-Identifier: Apache-2.0
// Output files that hold one document each.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "converters/common/output_pattern.h"
#include "libstyle/base/error.h"

namespace libstyle {

struct DocumentFile {
  Place place;             // where messages say the document comes from
  std::string name;        // of the document
  std::size_t number = 0;  // of the document, see OutputPattern
  std::string bytes;
};

// Writes each document to a file of its own if the name of the output is a pattern, else the only
// document to the output. That there is no second one must be known before the first is written.
class DocumentFiles {
 public:
  // `otherwise` completes the advice to who has several documents and no pattern.
  explicit DocumentFiles(const std::string& output, std::string otherwise = "")
      : names_(output), otherwise_(std::move(otherwise)) {}

  // Throws OutputError when it cannot be written, or is the second without a pattern.
  void add(DocumentFile file);

  // Writes what has waited.
  void finish();

 private:
  void write(const DocumentFile& file);

  OutputPattern names_;
  std::string otherwise_;
  std::optional<DocumentFile> only_;
};

}  // namespace libstyle
