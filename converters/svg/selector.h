// SPDX-License-Identifier: Apache-2.0
// CSS selectors: what they are, how they are read, and whether an element matches.
//
// Known: * type .class #id, [a] [a=v] [a~=v] [a|=v] [a^=v] [a$=v] [a*=v], the combinators for
// descendants, children (>), next (+) and later (~) siblings, :first-child :last-child :only-child
// :nth-child(an+b), the same four ending in -of-type, :root :empty :lang() :link :not(). Those that
// speak of a reader's doings (:hover, :visited and their like) are read and match nothing.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace libstyle::svg {

struct AttributeTest {
  enum class Kind : std::uint8_t { kPresent, kEqual, kWord, kDash, kPrefix, kSuffix, kPart };

  std::string name;
  Kind kind = Kind::kPresent;
  std::string value;
  bool ignores_case = false;  // [a=v i]
};

struct CompoundSelector;

struct PseudoClass {
  enum class Kind : std::uint8_t { kPlace, kRoot, kEmpty, kLanguage, kLink, kNot, kNever };

  Kind kind = Kind::kNever;
  // Of kPlace, counted from 1: step n + offset for some n >= 0.
  int step = 0;
  int offset = 1;
  bool from_end = false;
  bool of_type = false;                     // only siblings of the same type count
  std::vector<std::string> languages;       // of kLanguage
  std::vector<CompoundSelector> arguments;  // of kNot
};

// Tests of one element, all of which must hold.
struct CompoundSelector {
  std::string type;  // empty: any
  std::vector<std::string> ids;
  std::vector<std::string> classes;
  std::vector<AttributeTest> attributes;
  std::vector<PseudoClass> pseudo_classes;
};

enum class Combinator : std::uint8_t { kDescendant, kChild, kNextSibling, kLaterSibling };

struct Specificity {
  int ids = 0;
  int classes = 0;  // and attributes and pseudo-classes
  int types = 0;

  friend auto operator<=>(const Specificity&, const Specificity&) = default;
};

struct Selector {
  std::vector<CompoundSelector> compounds;  // as written; the last is of the element itself
  std::vector<Combinator> combinators;      // between them
  Specificity specificity;
};

// "rect, g > .thin". Nothing when any part is not understood: CSS then drops the whole list.
std::optional<std::vector<Selector>> parse_selector_list(std::string_view text);

// Takes its cost, in elements looked at, off `steps_left`; when that is used up nothing matches. (A
// selector of a few words can ask for any number of steps.)
bool matches(const Selector& selector, pugi::xml_node element, std::size_t& steps_left);

}  // namespace libstyle::svg
