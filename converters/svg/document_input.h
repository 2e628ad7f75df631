// SPDX-License-Identifier: Apache-2.0
// The documents of named inputs, whatever these hold: a stream of curves, or one SVG drawing.
//
// What it is shows in its first character: every line of curves begins with "{", no SVG does.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "libstyle/base/warning.h"
#include "libstyle/curves/document.h"

namespace libstyle {

// A document as it is taken from an input: read if it is curves, still text if it is SVG, so that
// another thread can go on with it.
struct TakenDocument {
  std::string input;       // its name as given
  std::size_t number = 0;  // its place in all that a program reads, from 1
  std::variant<Document, std::string> content;
};

// The document itself, named after the file if it comes from SVG. Throws Error as read_svg does.
Document to_document(TakenDocument taken, const WarningHandler& warn);

class DocumentInput {
 public:
  // Opens a file, or stdin for "-". Throws Error naming it when it cannot be opened. Warnings are
  // those of read().
  DocumentInput(const std::string& name, WarningHandler warn);
  ~DocumentInput();

  // Takes the next document out. Returns false when there is none. Throws Error as Reader::read
  // does, and goes on like it.
  bool take(TakenDocument& taken);

  // The next document itself; empty when there is none.
  bool read(Document& document);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
  WarningHandler warn_;
};

// The documents of all inputs of a program, one input after the other.
class DocumentInputs {
 public:
  explicit DocumentInputs(std::vector<std::string> names) : names_(std::move(names)) {}

  // Throws Error for an input that cannot be opened or holds no document, and as
  // DocumentInput::take does. The next call goes on behind what was bad, which counts as one
  // document.
  bool take(TakenDocument& taken);

 private:
  std::vector<std::string> names_;
  std::size_t opened_ = 0;  // how many of them
  std::size_t number_ = 0;
  std::unique_ptr<DocumentInput> input_;
  bool is_untouched_ = false;  // nothing has come out of input_
};

}  // namespace libstyle
