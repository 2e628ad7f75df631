// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/selector.h"

#include <algorithm>

#include "converters/svg/scanner.h"

namespace libstyle::svg {
namespace {

pugi::xml_node previous_element(pugi::xml_node element) {
  do {
    element = element.previous_sibling();
  } while (element && element.type() != pugi::node_element);
  return element;
}

pugi::xml_node next_element(pugi::xml_node element) {
  do {
    element = element.next_sibling();
  } while (element && element.type() != pugi::node_element);
  return element;
}

// Whether `word` stands in a list of words separated by white space.
bool has_word(std::string_view list, std::string_view word) {
  for (std::size_t at = list.find(word); at != list.npos; at = list.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || is_space(list[at - 1]);
    const bool ends = end == list.size() || is_space(list[end]);
    if (begins && ends) return !word.empty();
  }
  return false;
}

bool holds(const AttributeTest& test, pugi::xml_node element) {
  const pugi::xml_attribute attribute = element.attribute(test.name.c_str());
  if (!attribute) return false;
  const std::string_view value = attribute.value();
  using Kind = AttributeTest::Kind;
  switch (test.kind) {
    case Kind::kPresent:
      return true;
    case Kind::kEqual:
      return value == test.value;
    case Kind::kWord:
      return has_word(value, test.value);
    case Kind::kDash:
      return value == test.value || value.starts_with(test.value + "-");
    case Kind::kPrefix:
      return !test.value.empty() && value.starts_with(test.value);
    case Kind::kSuffix:
      return !test.value.empty() && value.ends_with(test.value);
    case Kind::kPart:
      return !test.value.empty() && value.find(test.value) != value.npos;
  }
  return false;
}

// Whether index = step n + offset for an n >= 0.
bool is_nth(int index, const PseudoClass& pseudo) {
  const int beyond = index - pseudo.offset;
  if (pseudo.step == 0) return beyond == 0;
  return beyond % pseudo.step == 0 && beyond / pseudo.step >= 0;
}

template <typename Step>
int count_from(pugi::xml_node element, Step step) {
  int count = 0;
  for (; element; element = step(element)) ++count;
  return count;
}

bool holds(const CompoundSelector& compound, pugi::xml_node element);

bool holds(const PseudoClass& pseudo, pugi::xml_node element) {
  using Kind = PseudoClass::Kind;
  switch (pseudo.kind) {
    case Kind::kNthChild:
      return is_nth(count_from(element, previous_element), pseudo);
    case Kind::kNthLastChild:
      return is_nth(count_from(element, next_element), pseudo);
    case Kind::kRoot:
      return element.parent().type() == pugi::node_document;
    case Kind::kEmpty:
      return !element.first_child();
    case Kind::kNot:
      return std::ranges::none_of(pseudo.arguments, [&](const CompoundSelector& argument) {
        return holds(argument, element);
      });
    case Kind::kNever:
      return false;
  }
  return false;
}

bool holds(const CompoundSelector& compound, pugi::xml_node element) {
  if (!compound.type.empty() && compound.type != element.name()) return false;
  for (const std::string& id : compound.ids) {
    if (id != element.attribute("id").value()) return false;
  }
  for (const std::string& name : compound.classes) {
    if (!has_word(element.attribute("class").value(), name)) return false;
  }
  const auto test = [&](const auto& part) { return holds(part, element); };
  return std::ranges::all_of(compound.attributes, test) &&
         std::ranges::all_of(compound.pseudo_classes, test);
}

pugi::xml_node parent_element(pugi::xml_node element) {
  const pugi::xml_node parent = element.parent();
  return parent.type() == pugi::node_element ? parent : pugi::xml_node();
}

// Whether the first `count` compounds match with the last of them at `element`. Nearer ancestors
// and siblings are tried first; `budget` bounds the work of a selector made to be slow.
bool matches_front(const Selector& selector, std::size_t count, pugi::xml_node element,
                   int& budget) {
  if (--budget < 0 || !holds(selector.compounds[count - 1], element)) return false;
  if (count == 1) return true;
  const Combinator combinator = selector.combinators[count - 2];
  const bool upwards = combinator == Combinator::kDescendant || combinator == Combinator::kChild;
  const bool once = combinator == Combinator::kChild || combinator == Combinator::kNextSibling;
  const auto step = upwards ? parent_element : previous_element;
  for (pugi::xml_node other = step(element); other; other = step(other)) {
    if (matches_front(selector, count - 1, other, budget)) return true;
    if (once) return false;
  }
  return false;
}

}  // namespace

bool matches(const Selector& selector, pugi::xml_node element) {
  constexpr int kBudget = 10'000;  // elements tried; real style sheets need a few dozen
  int budget = kBudget;
  return matches_front(selector, selector.compounds.size(), element, budget);
}

}  // namespace libstyle::svg
