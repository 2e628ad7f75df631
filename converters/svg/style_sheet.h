// SPDX-License-Identifier: Apache-2.0
// Style sheets: rules read from text, and those of them that match an element, in cascade order.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "converters/svg/property.h"
#include "converters/svg/selector.h"
#include "libstyle/base/warning.h"

namespace libstyle::svg {

// Views the text it was read from.
struct Declaration {
  const Property* property = nullptr;
  std::string_view value;
  bool important = false;
};

// "fill: red; stroke: blue !important". What is not understood, and properties that nothing here
// reads, are left out, as CSS asks.
std::vector<Declaration> parse_declarations(std::string_view text);

class StyleSheets {
 public:
  // What matching may cost in all, in elements looked at: real sheets need a dozen for each
  // element.
  explicit StyleSheets(std::size_t step_limit) : steps_left_(step_limit) {}

  // Adds a sheet after those added before. Rules with selectors that are not understood, and
  // at-rules (@media, @import), are left out with a warning; @font-face and @charset silently.
  void add(std::string_view text, const Place& place, const WarningHandler& warn);

  bool empty() const { return rules_.empty(); }

  // The declarations of all rules that match, the ones that win last; !important is not considered.
  // Throws Error when all calls together have taken too long.
  void find_matching(pugi::xml_node element, std::vector<Declaration>& declarations) const;

 private:
  struct Rule {
    Selector selector;
    std::size_t block = 0;
  };
  // Rules by what their last compound demands first, so that few need to be tried.
  using Index = std::map<std::string, std::vector<std::size_t>, std::less<>>;

  void add_rule(std::string_view selectors, std::string_view block, const Place& place,
                const WarningHandler& warn);
  void index_rule(std::size_t rule);
  void collect_candidates(pugi::xml_node element, std::vector<std::size_t>& candidates) const;

  std::deque<std::string> texts_;  // the declarations view them
  std::vector<std::vector<Declaration>> blocks_;
  std::vector<Rule> rules_;
  Index by_id_, by_class_, by_type_;
  std::vector<std::size_t> of_any_;
  Place place_;  // of the last sheet
  mutable std::size_t steps_left_;
};

}  // namespace libstyle::svg
