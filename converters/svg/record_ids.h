// SPDX-License-Identifier: Apache-2.0
// The ids that the records of a document have as XML elements.
//
// An id that somebody gave stays. An id that a program made (document.h, given_id) loses its "~"
// and what follows; what is left goes to the first record that asks for it. Other records then do
// without, but for those that something refers to, in the document or by being in them: these get a
// number behind the given part or their type: "g-2" for "g~2", "clip-1" for "~7".
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "libstyle/curves/document.h"

namespace libstyle::svg {

class RecordIds {
 public:
  // The document outlives this.
  explicit RecordIds(const Document& document);

  // The id of the record at `place` of the document; empty: none.
  const std::string& at(std::size_t place) const { return ids_[place]; }

  // The id of the record that a reference means; empty when there is no such record.
  const std::string& find(std::string_view record_id) const;

  // The place of that record in the document.
  static constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();
  std::size_t place(std::string_view record_id) const;

  // An id that nothing has had yet, for a record that stands once more.
  std::string make_another(const Record& record);

 private:
  void assign_given(const Document& document);
  void assign_made(const Document& document);
  std::string make_numbered(const Record& record, const RecordBase& base,
                            const std::string& wanted);
  std::string make_unique(const std::string& stem);

  std::vector<std::string> ids_;
  std::map<std::string_view, std::size_t> places_;  // of the first record with an id
  std::set<std::string> taken_;
  std::map<std::string, std::size_t> counts_;  // numbers given out, by stem
};

}  // namespace libstyle::svg
