// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <utility>

#include "converters/svg/css_text.h"
#include "converters/svg/scanner.h"
#include "converters/svg/selector.h"

namespace libstyle::svg {
namespace {

// ":not(:not(...))" cannot be written so deep by anyone who means well.
constexpr int kNestingLimit = 8;

class SelectorParser {
 public:
  explicit SelectorParser(std::string_view text, int nesting = 0)
      : scanner_(text), nesting_(nesting) {}

  bool parse_list(std::vector<Selector>& selectors) {
    do {
      Selector& selector = selectors.emplace_back();
      scanner_.skip_spaces();
      if (!parse_selector(selector)) return false;
    } while (scanner_.take(','));
    return scanner_.at_end();
  }

  bool parse_compound_list(std::vector<CompoundSelector>& compounds, Specificity& specificity) {
    do {
      scanner_.skip_spaces();
      if (!parse_compound(compounds.emplace_back(), specificity)) return false;
      scanner_.skip_spaces();
    } while (scanner_.take(','));
    return scanner_.at_end();
  }

 private:
  bool parse_selector(Selector& selector) {
    while (true) {
      if (!parse_compound(selector.compounds.emplace_back(), selector.specificity)) return false;
      const std::optional<Combinator> combinator = take_combinator();
      if (!combinator) return true;
      selector.combinators.push_back(*combinator);
    }
  }

  // What joins this compound to the next; nothing at the end of the selector.
  std::optional<Combinator> take_combinator() {
    const bool spaced = is_space(scanner_.peek());
    scanner_.skip_spaces();
    std::optional<Combinator> combinator;
    if (scanner_.take('>')) {
      combinator = Combinator::kChild;
    } else if (scanner_.take('+')) {
      combinator = Combinator::kNextSibling;
    } else if (scanner_.take('~')) {
      combinator = Combinator::kLaterSibling;
    } else if (spaced && !scanner_.at_end() && scanner_.peek() != ',') {
      combinator = Combinator::kDescendant;
    }
    scanner_.skip_spaces();
    return combinator;
  }

  bool parse_compound(CompoundSelector& compound, Specificity& specificity) {
    const std::size_t begin = scanner_.position();
    if (!scanner_.take('*')) {
      compound.type = take_identifier(scanner_);
      if (!compound.type.empty()) ++specificity.types;
    }
    while (true) {
      if (scanner_.take('#')) {
        ++specificity.ids;
        if (!take_name(compound.ids)) return false;
      } else if (scanner_.take('.')) {
        ++specificity.classes;
        if (!take_name(compound.classes)) return false;
      } else if (scanner_.take('[')) {
        ++specificity.classes;
        if (!parse_attribute(compound.attributes.emplace_back())) return false;
      } else if (scanner_.take(':')) {
        if (!parse_pseudo_class(compound.pseudo_classes.emplace_back(), specificity)) return false;
      } else {
        return scanner_.position() > begin;
      }
    }
  }

  bool take_name(std::vector<std::string>& names) {
    names.push_back(take_identifier(scanner_));
    return !names.back().empty();
  }

  bool parse_attribute(AttributeTest& test) {
    scanner_.skip_spaces();
    test.name = take_identifier(scanner_);
    if (test.name.empty()) return false;
    scanner_.skip_spaces();
    if (scanner_.take(']')) return true;
    if (!take_attribute_operator(test.kind)) return false;
    scanner_.skip_spaces();
    test.value = take_string_or_identifier(scanner_);
    scanner_.skip_spaces();
    return scanner_.take(']');
  }

  bool take_attribute_operator(AttributeTest::Kind& kind) {
    constexpr std::pair<char, AttributeTest::Kind> kOperators[] = {
        {'~', AttributeTest::Kind::kWord},   {'|', AttributeTest::Kind::kDash},
        {'^', AttributeTest::Kind::kPrefix}, {'$', AttributeTest::Kind::kSuffix},
        {'*', AttributeTest::Kind::kPart},
    };
    kind = AttributeTest::Kind::kEqual;
    for (const auto& [sign, meaning] : kOperators) {
      if (scanner_.take(sign)) {
        kind = meaning;
        break;
      }
    }
    return scanner_.take('=');
  }

  bool parse_pseudo_class(PseudoClass& pseudo, Specificity& specificity) {
    const std::string name = take_identifier(scanner_);
    if (name == "not") return parse_not(pseudo, specificity);
    ++specificity.classes;
    using Kind = PseudoClass::Kind;
    if (name == "nth-child" || name == "nth-last-child") {
      pseudo.kind = name == "nth-child" ? Kind::kNthChild : Kind::kNthLastChild;
      return parse_nth(take_argument(scanner_), pseudo);
    }
    if (name == "first-child") {
      pseudo.kind = Kind::kNthChild;
    } else if (name == "last-child") {
      pseudo.kind = Kind::kNthLastChild;
    } else if (name == "root") {
      pseudo.kind = Kind::kRoot;
    } else if (name == "empty") {
      pseudo.kind = Kind::kEmpty;
    } else {
      return is_never(name);
    }
    return true;
  }

  static bool is_never(std::string_view name) {
    constexpr std::string_view kNames[] = {"link",  "any-link", "visited", "hover",
                                           "focus", "active",   "target"};
    return std::ranges::find(kNames, name) != std::end(kNames);
  }

  // :not() counts as what is in it.
  bool parse_not(PseudoClass& pseudo, Specificity& specificity) {
    pseudo.kind = PseudoClass::Kind::kNot;
    const std::string argument = take_argument(scanner_);
    SelectorParser inner(argument, nesting_ + 1);
    return nesting_ < kNestingLimit && inner.parse_compound_list(pseudo.arguments, specificity);
  }

  // "odd", "even", "3", "2n+1", "-n + 3".
  static bool parse_nth(std::string_view text, PseudoClass& pseudo) {
    std::string compact;
    for (const char c : text) {
      if (!is_space(c)) compact += to_lower(c);
    }
    if (compact == "odd") compact = "2n+1";
    if (compact == "even") compact = "2n";
    const std::size_t n = compact.find('n');
    if (n == compact.npos) return parse_integer(compact, pseudo.offset);
    const std::string step = compact.substr(0, n);
    const std::string offset = compact.substr(n + 1);
    if (step.empty() || step == "+" || step == "-") {
      pseudo.step = step == "-" ? -1 : 1;
    } else if (!parse_integer(step, pseudo.step)) {
      return false;
    }
    pseudo.offset = 0;
    return offset.empty() || parse_integer(offset, pseudo.offset);
  }

  static bool parse_integer(std::string_view text, int& value) {
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc() && result.ptr == text.data() + text.size();
  }

  Scanner scanner_;
  int nesting_;
};

}  // namespace

std::optional<std::vector<Selector>> parse_selector_list(std::string_view text) {
  std::vector<Selector> selectors;
  if (!SelectorParser(text).parse_list(selectors)) return std::nullopt;
  return selectors;
}

}  // namespace libstyle::svg
