// SPDX-License-Identifier: Apache-2.0
// The names of outputs for a stream of documents: "out/{name}.png".
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace libstyle {

// "{name}" stands for the name of the document, "{number}" for its place in the stream, from 1.
//
// A document cannot choose where its output goes: in its name, '/' and control characters become
// '_', so does a '.' in front, an empty name becomes "unnamed", and names over 200 bytes are cut.
// When a name comes out a second time, "-2", "-3" and so on is put behind the document's name: no
// output of a run replaces another.
class OutputPattern {
 public:
  // Throws UsageError for any other word in braces.
  explicit OutputPattern(std::string pattern);

  // Whether there is a name for more than one document.
  bool takes_several() const { return takes_several_; }

  // The output for the next document of the stream. `number` is its place there, from 1: documents
  // before it may have been left out.
  std::string next(std::string_view document_name, std::size_t number);

 private:
  std::string expanded(std::string_view name, std::size_t number) const;

  std::string pattern_;
  bool takes_several_ = false;
  std::map<std::string, std::size_t> uses_;  // how often an output name has been asked for
};

}  // namespace libstyle
