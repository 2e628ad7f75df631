// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/selector.h"

#include <algorithm>

#include "converters/svg/file_index.h"
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
  for (std::size_t at = list.find(word); at != std::string_view::npos;
       at = list.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || is_space(list[at - 1]);
    const bool ends = end == list.size() || is_space(list[end]);
    if (begins && ends) return !word.empty();
  }
  return false;
}

std::string in_lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), to_lower);
  return text;
}

bool holds(const AttributeTest& test, std::string_view value);

bool holds(const AttributeTest& test, pugi::xml_node element) {
  const pugi::xml_attribute attribute = element.attribute(test.name.c_str());
  if (!attribute) return false;
  if (!test.ignores_case) return holds(test, std::string_view(attribute.value()));
  AttributeTest lower = test;
  lower.value = in_lower_case(test.value);
  return holds(lower, std::string_view(in_lower_case(attribute.value())));
}

bool holds(const AttributeTest& test, std::string_view value) {
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
      return !test.value.empty() && value.find(test.value) != std::string_view::npos;
  }
  return false;
}

// Whether index = step n + offset for an n >= 0.
bool is_nth(int index, const PseudoClass& pseudo) {
  const int beyond = index - pseudo.offset;
  if (pseudo.step == 0) return beyond == 0;
  return beyond % pseudo.step == 0 && beyond / pseudo.step >= 0;
}

// The place of an element among its siblings, from 1.
int place_of(pugi::xml_node element, const PseudoClass& pseudo, std::size_t& steps_left) {
  const auto step = pseudo.from_end ? next_element : previous_element;
  const std::string_view type = element.name();
  int place = 1;
  for (pugi::xml_node other = step(element); other; other = step(other)) {
    if (!pseudo.of_type || type == other.name()) ++place;
    if (steps_left > 0) --steps_left;
  }
  return place;
}

// "de" stands for itself and all that begins with "de-".
bool is_language(std::string_view language, std::string_view range) {
  return !range.empty() && language.size() >= range.size() &&
         equal_ignoring_case(language.substr(0, range.size()), range) &&
         (language.size() == range.size() || language[range.size()] == '-');
}

// The language of an element is that of the nearest xml:lang.
bool has_language(pugi::xml_node element, const std::vector<std::string>& ranges) {
  for (; element; element = element.parent()) {
    const pugi::xml_attribute language = element.attribute("xml:lang");
    if (!language) continue;
    return std::ranges::any_of(
        ranges, [&](const std::string& range) { return is_language(language.value(), range); });
  }
  return false;
}

// No link has been followed, so each is one (:link) and none is another (:visited).
bool is_link(pugi::xml_node element) {
  const bool leads = element.attribute("href") || element.attribute("xlink:href");
  return leads && std::string_view(element.name()) == "a";
}

bool holds(const CompoundSelector& compound, pugi::xml_node element, std::size_t& steps_left);

bool holds(const PseudoClass& pseudo, pugi::xml_node element, std::size_t& steps_left) {
  using Kind = PseudoClass::Kind;
  switch (pseudo.kind) {
    case Kind::kPlace:
      return is_nth(place_of(element, pseudo, steps_left), pseudo);
    case Kind::kRoot:
      return element.parent().type() == pugi::node_document;
    case Kind::kEmpty:
      return !element.first_child();
    case Kind::kLanguage:
      return has_language(element, pseudo.languages);
    case Kind::kLink:
      return is_link(element);
    case Kind::kNot:
      return std::ranges::none_of(pseudo.arguments, [&](const CompoundSelector& argument) {
        return holds(argument, element, steps_left);
      });
    case Kind::kNever:
      return false;
  }
  return false;
}

bool holds(const CompoundSelector& compound, pugi::xml_node element, std::size_t& steps_left) {
  if (steps_left == 0) return false;
  --steps_left;
  if (!compound.type.empty() && compound.type != element.name()) return false;
  for (const std::string& id : compound.ids) {
    if (id != element.attribute("id").value()) return false;
  }
  for (const std::string& name : compound.classes) {
    if (!has_word(element.attribute("class").value(), name)) return false;
  }
  return std::ranges::all_of(compound.attributes,
                             [&](const AttributeTest& test) { return holds(test, element); }) &&
         std::ranges::all_of(compound.pseudo_classes, [&](const PseudoClass& pseudo) {
           return holds(pseudo, element, steps_left);
         });
}

pugi::xml_node parent_element(pugi::xml_node element) {
  const pugi::xml_node parent = element.parent();
  return parent.type() == pugi::node_element ? parent : pugi::xml_node();
}

// Whether the first `count` compounds match with the last of them at `element`. Nearer ancestors
// and siblings are tried first.
bool matches_front(const Selector& selector, std::size_t count, pugi::xml_node element,
                   std::size_t& steps_left) {
  if (!holds(selector.compounds[count - 1], element, steps_left)) return false;
  if (count == 1) return true;
  const Combinator combinator = selector.combinators[count - 2];
  const bool upwards = combinator == Combinator::kDescendant || combinator == Combinator::kChild;
  const bool once = combinator == Combinator::kChild || combinator == Combinator::kNextSibling;
  const auto step = upwards ? parent_element : previous_element;
  for (pugi::xml_node other = step(element); other; other = step(other)) {
    if (matches_front(selector, count - 1, other, steps_left)) return true;
    if (once) return false;
  }
  return false;
}

}  // namespace

bool matches(const Selector& selector, pugi::xml_node element, std::size_t& steps_left) {
  return matches_front(selector, selector.compounds.size(), element, steps_left);
}

}  // namespace libstyle::svg
