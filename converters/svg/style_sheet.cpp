// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/style_sheet.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "converters/svg/css_text.h"

namespace libstyle::svg {
namespace {

// Takes "!important" off the end of a value.
bool take_important(std::string_view& value) {
  const std::size_t mark = value.rfind('!');
  if (mark == std::string_view::npos) return false;
  if (!equal_ignoring_case(trimmed(value.substr(mark + 1)), "important")) return false;
  value = trimmed(value.substr(0, mark));
  return true;
}

// Names are in lower case, for librsvg.
std::optional<Declaration> parse_declaration(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::string_view name = trimmed(text.substr(0, colon));
  Declaration declaration{find_property(name), trimmed(text.substr(colon + 1))};
  declaration.important = take_important(declaration.value);
  if (declaration.property == nullptr) return std::nullopt;
  return declaration;
}

// "media" of "@media screen"; "" when `text` is no at-rule.
std::string at_rule_name(std::string_view text) {
  Scanner scanner(text);
  return scanner.take('@') ? take_identifier(scanner) : "";
}

// Without words for fonts and movement these have nothing to say about lines.
bool is_silent(std::string_view at_rule) {
  return at_rule == "charset" || at_rule == "font-face" || at_rule == "namespace" ||
         at_rule.ends_with("keyframes");
}

// What HTML once needed around style sheets, and people still write.
std::string_view without_html_comments(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with("<!--")) text.remove_prefix(4);
  if (text.ends_with("-->")) text.remove_suffix(3);
  return trimmed(text);
}

}  // namespace

std::vector<Declaration> parse_declarations(std::string_view text) {
  std::vector<Declaration> declarations;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = find_outside(text, ";", begin);
    if (const auto found = parse_declaration(text.substr(begin, end - begin))) {
      declarations.push_back(*found);
    }
    begin = end + 1;
  }
  return declarations;
}

void StyleSheets::add(std::string_view text, const Place& place, const WarningHandler& warn) {
  if (!text.empty()) place_ = place;
  texts_.push_back(without_comments(text));
  std::string_view rest = without_html_comments(texts_.back());
  while (!rest.empty()) {
    const std::size_t open = find_outside(rest, rest.starts_with('@') ? "{;" : "{", 0);
    const std::string_view prelude = trimmed(rest.substr(0, open));
    const bool has_block = open < rest.size() && rest[open] == '{';
    const std::size_t close = has_block ? find_outside(rest, "}", open + 1) : open;
    const std::string at_rule = at_rule_name(prelude);
    if (!at_rule.empty()) {
      if (!is_silent(at_rule)) warn({place, "", "@" + at_rule + " in a style sheet is left out"});
    } else if (has_block) {
      add_rule(prelude, rest.substr(open + 1, close - open - 1), place, warn);
    }
    rest.remove_prefix(std::min(close + 1, rest.size()));
    rest = trimmed(rest);
  }
}

void StyleSheets::add_rule(std::string_view selectors, std::string_view block, const Place& place,
                           const WarningHandler& warn) {
  std::optional<std::vector<Selector>> parsed = parse_selector_list(selectors);
  if (!parsed) {
    warn({place, "", "the selector \"" + std::string(selectors) + "\" is not understood"});
    return;
  }
  std::vector<Declaration> declarations = parse_declarations(block);
  if (declarations.empty()) return;
  blocks_.push_back(std::move(declarations));
  for (Selector& selector : *parsed) {
    rules_.push_back({std::move(selector), blocks_.size() - 1});
    index_rule(rules_.size() - 1);
  }
}

void StyleSheets::index_rule(std::size_t rule) {
  const CompoundSelector& last = rules_[rule].selector.compounds.back();
  if (!last.ids.empty()) {
    by_id_[last.ids.front()].push_back(rule);
  } else if (!last.classes.empty()) {
    by_class_[last.classes.front()].push_back(rule);
  } else if (!last.type.empty()) {
    by_type_[last.type].push_back(rule);
  } else {
    of_any_.push_back(rule);
  }
}

void StyleSheets::collect_candidates(pugi::xml_node element,
                                     std::vector<std::size_t>& candidates) const {
  candidates = of_any_;
  const auto collect = [&](const Index& index, std::string_view key) {
    const auto found = index.find(key);
    if (found == index.end()) return;
    candidates.insert(candidates.end(), found->second.begin(), found->second.end());
  };
  collect(by_type_, element.name());
  collect(by_id_, element.attribute("id").value());
  std::string_view classes = trimmed(element.attribute("class").value());
  while (!classes.empty()) {
    const std::size_t end = std::min(classes.find_first_of(" \t\r\n\f"), classes.size());
    collect(by_class_, classes.substr(0, end));
    classes = trimmed(classes.substr(end));
  }
}

void StyleSheets::find_matching(pugi::xml_node element,
                                std::vector<Declaration>& declarations) const {
  std::vector<std::size_t> matching;
  collect_candidates(element, matching);
  std::erase_if(matching, [&](std::size_t rule) {
    return !matches(rules_[rule].selector, element, steps_left_);
  });
  std::ranges::sort(matching, {}, [&](std::size_t rule) {
    return std::tuple(rules_[rule].selector.specificity, rule);
  });
  for (const std::size_t rule : matching) {
    const std::vector<Declaration>& block = blocks_[rules_[rule].block];
    declarations.insert(declarations.end(), block.begin(), block.end());
    steps_left_ -= std::min(steps_left_, block.size());
  }
  if (steps_left_ == 0) throw Error(place_, "the style sheet takes too long to match");
}

}  // namespace libstyle::svg
