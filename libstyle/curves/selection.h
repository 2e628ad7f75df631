// SPDX-License-Identifier: Apache-2.0
// Parts of a document, picked by name.
//
// A selector is a list of terms with commas between them; what any of them names is selected, and
// with a group or element everything in it:
//   #wall       the id; of what `use` drew several times, every copy
//   .door       a class
//   rect        what a path was drawn as: rect, circle, ellipse, line, polyline, polygon, path, ...
//   layer:Name  a layer, by the label that drawing programs show, or else by its id
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libstyle/curves/document.h"

namespace libstyle {

// What a term without a mark names.
enum class BareWord : std::uint8_t {
  kElement,  // what a path was drawn as
  kAnything  // what is called so in any way: by id, class, label or element; may have blanks
};

class RecordSelector {
 public:
  // Throws Error for a term that is empty or of another form.
  explicit RecordSelector(std::string_view text, BareWord bare = BareWord::kElement);

  // Whether a term names the record itself, not one around it.
  bool matches(const Record& record) const;

 private:
  struct Term {
    enum class Kind : std::uint8_t { kId, kClass, kShape, kLayer, kAnything };

    Kind kind = Kind::kId;
    std::string name;
  };

  static Term parse_term(std::string_view text, BareWord bare);
  static bool matches(const Term& term, const Record& record);

  std::vector<Term> terms_;
};

inline constexpr std::size_t kNotSelected = std::numeric_limits<std::size_t>::max();

// For each record the place of the selector that selects it: the one that names what is innermost,
// the record itself before its group, and of those that name the same, the last. kNotSelected if
// there is none, and for records that are not drawn.
std::vector<std::size_t> selected_by(const Document& document,
                                     std::span<const RecordSelector> selectors);

// Removes what is not selected. What selected records need stays: the groups and elements around
// them, their gradients and clips, the constraints, adjustments, labels and seeds that speak of
// them; records of unknown type stay, too. Returns whether anything was selected.
bool keep_selected(Document& document, const RecordSelector& selector);

}  // namespace libstyle
