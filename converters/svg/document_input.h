// SPDX-License-Identifier: Apache-2.0
// The documents of a named input, whatever it holds: a stream of curves, or one SVG drawing.
//
// What it is shows in its first character: every line of curves begins with "{", no SVG does.
#pragma once

#include <memory>
#include <string>

#include "libstyle/base/warning.h"
#include "libstyle/curves/document.h"

namespace libstyle {

class DocumentInput {
 public:
  // Opens a file, or stdin for "-". Throws Error naming it when it cannot be opened. Warnings are
  // those of reading SVG.
  DocumentInput(const std::string& name, WarningHandler warn);
  ~DocumentInput();

  // Replaces `document` by the next one, named after the file if it comes from SVG. Returns false,
  // with `document` empty, when there is none. Throws Error as Reader::read and read_svg do.
  bool read(Document& document);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace libstyle
