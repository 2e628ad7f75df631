// SPDX-License-Identifier: Apache-2.0
// Inputs and outputs of the programs: files, stdin and stdout under the name "-".
#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <string>
#include <string_view>

#include "libstyle/base/bytes.h"
#include "libstyle/base/error.h"

namespace libstyle {

// The reader of our output has gone; the program ends quietly.
class ClosedPipe : public std::exception {};

// An output cannot take what is to be written: another input would not help.
class OutputError : public Error {
 public:
  using Error::Error;
};

// Opens a file, or stdin for "-". Throws Error naming the file: missing, a folder, no permission.
std::unique_ptr<ByteSource> open_input(const std::string& name);

// How messages call an input: "stdin" for "-".
std::string display_name(const std::string& name);

// The stem that names a document: "drawings/plan.svg" -> "plan"; "stdin" for "-".
std::string document_name(const std::string& input_name);

// Reads all of a source, at most `limit` bytes; throws Error when there is more.
std::string read_all(ByteSource& source, std::size_t limit, const std::string& name);

// An output that is there whole or not at all: a named file is written beside its place and renamed
// by commit(); without commit() it vanishes. Stdout ("-"), devices and named pipes are written as
// they are. All calls throw OutputError when the bytes cannot be written, ClosedPipe when nobody
// reads.
class OutputFile final : public ByteSink {
 public:
  explicit OutputFile(const std::string& name);
  ~OutputFile() override;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes) override;
  void commit();

 private:
  std::string name_;         // for messages
  std::string destination_;  // what commit() renames to
  std::string temporary_;    // empty where there is nothing to rename: stdout, a device, a pipe
  int descriptor_ = -1;
};

}  // namespace libstyle
